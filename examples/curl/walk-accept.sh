#!/usr/bin/env bash
# Take what was seen on a walk for true; --partial: also if some places were not seen, or have changed since.
#   HOISTWAY=http://localhost:8080 ./walk-accept.sh 1
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
walk=${1:?which walk?} partial=false
[[ ${2-} != --partial ]] || partial=true

curl -sS --fail-with-body --json "{\"partial\": $partial}" -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/walks/$walk/accept"
echo
