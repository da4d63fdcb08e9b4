#!/usr/bin/env bash
# Lock a device out while people work at it: no command, no way through, until you lift it (or two others together).
#   HOISTWAY=http://localhost:8080 ./device-lockout.sh DOOR1 "new motor"
#   HOISTWAY=http://localhost:8080 ./device-lockout.sh DOOR1 --lift
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
device=${1:?which device?} reason=${2:?why, or --lift?}
lockout="$HOISTWAY/api/v1/devices/$device/lockout"

if [[ $reason == --lift ]]; then
  curl -fsS -X DELETE -H "X-Actor: $ACTOR" "$lockout"
else
  curl -fsS --json "{\"reason\": \"$reason\"}" -H "X-Actor: $ACTOR" "$lockout"
fi
echo
