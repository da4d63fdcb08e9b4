#!/usr/bin/env bash
# Open a door and wait until it is open. It closes by itself a minute later, unless somebody drives through.
#   HOISTWAY=http://localhost:8080 ./door-open.sh DOOR1
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DOOR" "$@"

exec "$(dirname -- "$0")/device-command.sh" "$1" open
