#!/usr/bin/env bash
# End a closure by its number; one for people's work is ended by its owner, or by two others one after the other.
#   HOISTWAY=http://localhost:8080 ./closure-open.sh 3 "rail is back"
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
number=${1:?which closure?} reason=${2-}

curl -sS --fail-with-body --json "{\"reason\": \"$reason\"}" -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/closures/$number/open"
echo
