#!/usr/bin/env bash
# Stop all drives of a line at once.
#   HOISTWAY=http://localhost:8080 ./drive-stop-all.sh axes
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "LINE" "$@"

answer=$(ask POST "/links/$1/stop?wait=5") || true # what is wrong with it is seen below
echo "$answer"
grep -q '"state":"done"' <<<"$answer"
