#!/usr/bin/env bash
# Say that you know of an alarm; it goes on until its cause is gone.
#   HOISTWAY=http://localhost:8080 ./alarm-acknowledge.sh 17 "a wheel is worn"
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
number=${1:?which alarm?} note=${2-}

curl -sS --fail-with-body --json "{\"note\": \"$note\"}" -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/alarms/$number/acknowledge"
echo
