#!/usr/bin/env bash
# Read all 256 parameters of a drive, with progress, then print what is known of each.
#   HOISTWAY=http://localhost:8080 ./drive-read-all.sh AX1
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DRIVE" "$@"

operation=$(api POST "/drives/$1/read" '{}' | field id)
while state=$(api GET "/operations/$operation?wait=1") && [ "$(field state <<<"$state")" = running ]; do
    echo "$(field done <<<"$state") of $(field total <<<"$state")" >&2
done
ask GET "/drives/$1/parameters"
echo
[ "$(field state <<<"$state")" = done ] || { field reason <<<"$state" >&2; exit 1; }
