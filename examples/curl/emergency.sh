#!/usr/bin/env bash
# Tell a fire or an earthquake: everything stops, doors do as the plant file says. Then release it, and resume.
#   HOISTWAY=http://localhost:8080 ./emergency.sh fire "smoke in bay 2"
#   HOISTWAY=http://localhost:8080 ./emergency.sh --release fire "false alarm, seen" && curl -X POST $HOISTWAY/api/v1/controller/resume
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
path="$HOISTWAY/api/v1/controller/emergency"
if [[ ${1-} == --release ]]; then
  path+=/release
  shift
fi

curl -fsS --json "{\"kind\": \"${1:?fire or earthquake?}\", \"reason\": \"${2:?why?}\"}" -H "X-Actor: $ACTOR" "$path"
echo
