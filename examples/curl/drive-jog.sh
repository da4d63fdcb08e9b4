#!/usr/bin/env bash
# Jog an axis for some seconds. The drive's panel must be in jog. If this script dies, the axis stops within half a second.
#   HOISTWAY=http://localhost:8080 ./drive-jog.sh AX1 cw 2
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DRIVE cw|ccw [SECONDS]" "$@"
seconds=${3:-1}
[[ $seconds =~ ^[0-9]+$ ]] || { echo "for how long? Say whole seconds, not $seconds" >&2; exit 2; }

body=$(object direction="$2")
jog=$(api POST "/drives/$1/jog" "$body" | field jog)
held="/drives/$1/jog/$jog"
# Eight times a second, by one curl: to start one for each could take longer than the half second. What follows # only counts.
keyed -fsS --fail-early --rate 8/s -X POST "$HOISTWAY/api/v1$held#[1-$((8 * seconds))]" >/dev/null || true
api DELETE "$held?wait=5" || ask GET "$held"
echo
