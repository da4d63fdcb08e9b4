#!/usr/bin/env bash
# Lock a buffer for yourself and wait until it is locked: no vehicle is served there until you unlock it.
#   HOISTWAY=http://localhost:8080 ./buffer-lock.sh BUFFER1
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "BUFFER" "$@"

exec "$(dirname -- "$0")/device-command.sh" "$1" lock
