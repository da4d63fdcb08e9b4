#!/usr/bin/env bash
# Write one parameter, in its unit, and only if the drive still has what we saw. It is read back.
#   HOISTWAY=http://localhost:8080 ./drive-write.sh AX1 00 2.5
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DRIVE PARAMETER VALUE" "$@"
parameter="/drives/$1/parameters/$2"

body=$(object value:="$3")
api POST "$parameter/read?wait=10" >/dev/null
etag=$(api GET "$parameter" "" --include | sed -n 's/^[Ee][Tt][Aa][Gg]: *\(.*[^[:space:]]\).*/\1/p')
answer=$(ask PUT "$parameter?wait=10" "$body" --header "If-Match: $etag") || true # what is wrong with it is seen below
echo "$answer"
grep -q '"state":"done"' <<<"$answer"
