#!/usr/bin/env bash
# Unlock a buffer and wait until it is unlocked. Refused while a vehicle is served there: the answer says which.
#   HOISTWAY=http://localhost:8080 ./buffer-unlock.sh BUFFER1
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "BUFFER" "$@"

exec "$(dirname -- "$0")/device-command.sh" "$1" unlock
