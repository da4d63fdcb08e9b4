#!/usr/bin/env bash
# Begin an audit walk along all side buffers, or along the stations named.
#   HOISTWAY=http://localhost:8080 ./walk-start.sh "after the outage"
#   HOISTWAY=http://localhost:8080 ./walk-start.sh "spot check" B1 B2
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
reason=${1:?why?}
stations=$(printf ', "%s"' "${@:2}")
[[ $# -gt 1 ]] || stations=""

curl -sS --fail-with-body --json "{\"reason\": \"$reason\", \"stations\": [${stations#, }]}" \
  -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/walks"
echo
