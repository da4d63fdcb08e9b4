#!/usr/bin/env bash
# Show the error of a drive with its meaning and remedy, reset it, and show the status after that.
#   HOISTWAY=http://localhost:8080 ./drive-reset.sh AX1
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
drive=${1:?which drive?}

curl -fsS "$HOISTWAY/api/v1/drives/$drive"
echo
curl -fsS --json '{"key": "stop_reset"}' -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/drives/$drive/keys?wait=10"
echo
curl -fsS -X POST -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/drives/$drive/status?wait=10"
echo
