#!/usr/bin/env bash
# Read all 256 parameters of a drive, with progress, then print what is known of each.
#   HOISTWAY=http://localhost:8080 ./drive-read-all.sh AX1
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
drive=${1:?which drive?}

field() { sed -n "s/.*\"$1\":\"\{0,1\}\([^\",}]*\).*/\1/p"; }

operation=$(curl -fsS --json '{}' -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/drives/$drive/read" | field id)
while state=$(curl -fsS "$HOISTWAY/api/v1/operations/$operation?wait=1") && [ "$(field state <<<"$state")" = running ]; do
    echo "$(field done <<<"$state") of $(field total <<<"$state")" >&2
done
curl -fsS "$HOISTWAY/api/v1/drives/$drive/parameters"
echo
[ "$(field state <<<"$state")" = done ] || { field reason <<<"$state" >&2; exit 1; }
