#!/usr/bin/env bash
# Keep a door open or closed, whatever vehicles want, until you give it back: they wait, and say who wants it so.
#   HOISTWAY=http://localhost:8080 ./door-keep.sh DOOR1 closed "cleaning the hall"
#   HOISTWAY=http://localhost:8080 ./door-keep.sh DOOR1 back
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DOOR open|closed|back [REASON]" "$@"

if [[ $2 == back ]]; then
  ask DELETE "/devices/$1/pin"
else
  usage "DOOR $2 REASON" "$@"
  body=$(object position="$2" reason="$3")
  ask PUT "/devices/$1/pin" "$body"
fi
echo
