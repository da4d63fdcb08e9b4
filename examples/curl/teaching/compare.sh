#!/usr/bin/env bash
# Compare two versions of a port (old new), or the OFFSETs of two vehicles and what each would be sent at the port.
#   ./compare.sh 1 2          ./compare.sh V001 V002
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "ONE OTHER" "$@"
if [[ $1 =~ ^[0-9]+$ ]]; then
  api GET "/teaching/compare/stations/$STATION/$1/$2" | field differences
else
  answer=$(api GET "/teaching/compare/offsets/$1/$2?station=$STATION")
  echo "OFFSET $2 - $1: $(field differences <<<"$answer")"
  echo "sent at $STATION: $1 $(field stations.0.one <<<"$answer"), $2 $(field stations.0.other <<<"$answer")"
fi
