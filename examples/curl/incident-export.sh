#!/usr/bin/env bash
# Keep what happened between two moments as one file, to be opened elsewhere: hoistway replay FILE
#   HOISTWAY=http://localhost:8080 ./incident-export.sh 2026-07-01T08:30:00Z 2026-07-01T08:45:00Z incident.hoistway.gz
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "FROM TO FILE" "$@"
file=$3

made=$(mktemp)
trap 'rm -f "$made"' EXIT
if ! ask GET /history/export "" --max-time 600 --get --data-urlencode "from=$1" --data-urlencode "to=$2" --output "$made"; then
  cat "$made" >&2 # why not
  exit 1
fi
cat "$made" >"$file"
object file="$file"
