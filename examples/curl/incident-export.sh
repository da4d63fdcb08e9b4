#!/usr/bin/env bash
# Keep what happened between two moments as one file, to be opened elsewhere: hoistway replay FILE
#   HOISTWAY=http://localhost:8080 ./incident-export.sh 2026-07-01T08:30:00Z 2026-07-01T08:45:00Z incident.hoistway.gz
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
from=${1:?from when?} to=${2:?to when?} file=${3:?into which file?}

made=$(mktemp)
trap 'rm -f "$made"' EXIT
if ! curl -sS --fail-with-body -G --data-urlencode "from=$from" --data-urlencode "to=$to" -H "X-Actor: $ACTOR" \
  -o "$made" "$HOISTWAY/api/v1/history/export"; then
  cat "$made" >&2 # why not
  exit 1
fi
cat "$made" >"$file"
echo "{\"file\": \"$file\"}"
