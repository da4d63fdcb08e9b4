#!/usr/bin/env bash
# Enter what stands at a place of a walk: empty, or full with the carrier's id if it can be read.
#   HOISTWAY=http://localhost:8080 ./walk-enter.sh 1 B2 full FOUP0002
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "WALK STATION empty|full [CARRIER]" "$@"
case $3 in
  empty) [[ -z ${4-} ]] || { echo "a place that is empty has no carrier: leave $4 out, or say full" >&2; exit 2; }
    body=$(object present:=false) ;;
  full) if [[ -n ${4-} ]]; then body=$(object present:=true carrier="$4"); else body=$(object present:=true carrier:=null); fi ;;
  *) echo "empty or full, not $3" >&2; exit 2 ;;
esac

ask PUT "/walks/$1/places/$2" "$body"
echo
