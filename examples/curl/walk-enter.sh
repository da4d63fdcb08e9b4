#!/usr/bin/env bash
# Enter what stands at a place of a walk: empty, or full with the carrier's id if it can be read.
#   HOISTWAY=http://localhost:8080 ./walk-enter.sh 1 B2 full FOUP0002
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
walk=${1:?which walk?} station=${2:?which station?}
case ${3:?empty or full?} in
  empty) body='{"present": false}' ;;
  full) body="{\"present\": true, \"carrier\": $([[ -n ${4-} ]] && echo "\"$4\"" || echo null)}" ;;
  *) echo "empty or full, not $3" >&2; exit 2 ;;
esac

curl -sS --fail-with-body -X PUT --json "$body" -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/walks/$walk/places/$station"
echo
