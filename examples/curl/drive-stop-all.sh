#!/usr/bin/env bash
# Stop all drives of a line at once.
#   HOISTWAY=http://localhost:8080 ./drive-stop-all.sh axes
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
line=${1:?which line?}

answer=$(curl -sS -X POST -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/links/$line/stop?wait=5")
echo "$answer"
grep -q '"state":"done"' <<<"$answer"
