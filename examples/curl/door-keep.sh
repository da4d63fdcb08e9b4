#!/usr/bin/env bash
# Keep a door open or closed, whatever vehicles want, until you give it back: they wait, and say who wants it so.
#   HOISTWAY=http://localhost:8080 ./door-keep.sh DOOR1 closed "cleaning the hall"
#   HOISTWAY=http://localhost:8080 ./door-keep.sh DOOR1 back
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
door=${1:?which door?} how=${2:?open, closed or back?}
pin="$HOISTWAY/api/v1/devices/$door/pin"

if [[ $how == back ]]; then
  curl -fsS -X DELETE -H "X-Actor: $ACTOR" "$pin"
else
  curl -fsS -X PUT --json "{\"position\": \"$how\", \"reason\": \"${3:?why?}\"}" -H "X-Actor: $ACTOR" "$pin"
fi
echo
