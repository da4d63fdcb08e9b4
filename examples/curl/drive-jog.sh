#!/usr/bin/env bash
# Jog an axis for some seconds. The drive's panel must be in jog. If this script dies, the axis stops within half a second.
#   HOISTWAY=http://localhost:8080 ./drive-jog.sh AX1 cw 2
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
drive=${1:?which drive?} direction=${2:?cw or ccw?} seconds=${3:-1}
[[ $seconds =~ ^[0-9]+$ ]] || { echo "for how long? Say whole seconds, not $seconds" >&2; exit 2; }

field() { sed -n "s/.*\"$1\":\"\{0,1\}\([^\",}]*\).*/\1/p"; }

answer=$(curl -sS --json "{\"direction\": \"$direction\"}" -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/drives/$drive/jog")
jog=$(field jog <<<"$answer")
[ -n "$jog" ] || { echo "$answer" >&2; exit 1; }
held="$HOISTWAY/api/v1/drives/$drive/jog/$jog"
# Eight times a second, by one curl: to start one for each could take longer than the half second. What follows # only counts.
curl -fsS --fail-early --rate 8/s -X POST "$held#[1-$((8 * seconds))]" >/dev/null || true
curl -fsS -X DELETE "$held?wait=5" || curl -fsS "$held"
echo
