#!/usr/bin/env bash
# Tell where a drive differs from a backup, by its number, or from another drive, by its name.
#   HOISTWAY=http://localhost:8080 ./drive-compare.sh AX1 12
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
drive=${1:?which drive?} with=${2:?which backup or drive?}

case $with in
    *[!0-9]*) body="{\"drive\": \"$with\"}" ;;
    *) body="{\"backup\": $with}" ;;
esac
answer=$(curl -sS --json "$body" -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/drives/$drive/compare?wait=60")
echo "$answer"
grep -q '"state":"done"' <<<"$answer"
