#!/usr/bin/env bash
# Take a charger, buffer or door out of service, or put it back.
#   HOISTWAY=http://localhost:8080 ./device-service.sh CHARGER1 "no current"
#   HOISTWAY=http://localhost:8080 ./device-service.sh CHARGER1
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
device=${1:?which device?} reason=${2-}
body="{\"in_service\": $([[ -z $reason ]] && echo true || echo false), \"reason\": \"$reason\"}"

curl -fsS -X PUT --json "$body" -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/devices/$device/service"
echo
