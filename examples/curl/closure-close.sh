#!/usr/bin/env bash
# Close a place: nobody comes in, those inside drive out. PURPOSE=work: people are there, so it never opens by itself.
#   HOISTWAY=http://localhost:8080 ./closure-close.sh "rail change" stretch 1203 1210
#   HOISTWAY=http://localhost:8080 PURPOSE=work ./closure-close.sh "new motor" station STK01-P02
#   HOISTWAY=http://localhost:8080 MINUTES=30 ./closure-close.sh "crowded" barcode 1203
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}" "${PURPOSE:=traffic}" "${MINUTES:=null}"
reason=${1:?why?}
place=$("$(dirname "$0")/closure-place.sh" "${@:2}")

curl -fsS --json "{\"place\": $place, \"reason\": \"$reason\", \"purpose\": \"$PURPOSE\", \"minutes\": $MINUTES}" \
  -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/closures"
echo
