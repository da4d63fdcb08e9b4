#!/usr/bin/env bash
# Begin an audit walk along all side buffers, or along the stations named.
#   HOISTWAY=http://localhost:8080 ./walk-start.sh "after the outage"
#   HOISTWAY=http://localhost:8080 ./walk-start.sh "spot check" B1 B2
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "REASON [STATION...]" "$@"
stations=$(list "${@:2}")

body=$(object reason="$1" stations:="$stations")
ask POST /walks "$body"
echo
