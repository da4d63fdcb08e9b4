#!/usr/bin/env bash
# Take what was seen on a walk for true; --partial: also if some places were not seen, or have changed since.
#   HOISTWAY=http://localhost:8080 ./walk-accept.sh 1
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "WALK [--partial]" "$@"
partial=false
[[ ${2-} != --partial ]] || partial=true

body=$(object partial:=$partial)
ask POST "/walks/$1/accept" "$body"
echo
