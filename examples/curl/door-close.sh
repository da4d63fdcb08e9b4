#!/usr/bin/env bash
# Close a door and wait until it is closed. Refused while anybody is in it, or granted the way through: the answer says who.
#   HOISTWAY=http://localhost:8080 ./door-close.sh DOOR1
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DOOR" "$@"

exec "$(dirname -- "$0")/device-command.sh" "$1" close
