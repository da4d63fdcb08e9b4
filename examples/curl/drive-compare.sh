#!/usr/bin/env bash
# Tell where a drive differs from a backup, by its number, or from another drive, by its name.
#   HOISTWAY=http://localhost:8080 ./drive-compare.sh AX1 12
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DRIVE BACKUP|DRIVE" "$@"

case $2 in
    *[!0-9]*) body=$(object drive="$2") ;;
    *) body=$(object backup:="$2") ;;
esac
answer=$(ask POST "/drives/$1/compare?wait=60" "$body") || true # what is wrong with it is seen below
echo "$answer"
grep -q '"state":"done"' <<<"$answer"
