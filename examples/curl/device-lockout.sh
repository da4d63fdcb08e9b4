#!/usr/bin/env bash
# Lock a device out while people work at it: no command, no way through, until you lift it (or two others together).
#   HOISTWAY=http://localhost:8080 ./device-lockout.sh DOOR1 "new motor"
#   HOISTWAY=http://localhost:8080 ./device-lockout.sh DOOR1 --lift
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DEVICE REASON|--lift" "$@"

if [[ $2 == --lift ]]; then
  ask DELETE "/devices/$1/lockout"
else
  body=$(object reason="$2")
  ask POST "/devices/$1/lockout" "$body"
fi
echo
