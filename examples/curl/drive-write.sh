#!/usr/bin/env bash
# Write one parameter, in its unit, and only if the drive still has what we saw. It is read back.
#   HOISTWAY=http://localhost:8080 ./drive-write.sh AX1 00 2.5
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
drive=${1:?which drive?} number=${2:?which parameter?} value=${3:?which value?}
parameter="$HOISTWAY/api/v1/drives/$drive/parameters/$number"

curl -fsS -X POST -H "X-Actor: $ACTOR" "$parameter/read?wait=10" >/dev/null
etag=$(curl -fsS -D - -o /dev/null "$parameter" | sed -n 's/^[Ee][Tt][Aa][Gg]: *\(.*[^[:space:]]\).*/\1/p')
answer=$(curl -sS -X PUT --json "{\"value\": $value}" -H "X-Actor: $ACTOR" -H "If-Match: $etag" "$parameter?wait=10")
echo "$answer"
grep -q '"state":"done"' <<<"$answer"
