#!/usr/bin/env bash
# Open a teaching session: from now on no job uses the port, and the vehicle gets none.
#   STATION=ETCH01-P1 VEHICLE=V001 ./open-session.sh "new load port"
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "[NOTE]" "$@"
body=$(object station="$STATION" vehicle="$VEHICLE" note="${1-}")
answer=$(api POST /teaching/sessions "$body")
echo "session $(field id <<<"$answer") is open; next: $(field advice <<<"$answer")"
