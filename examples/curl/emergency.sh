#!/usr/bin/env bash
# Tell a fire or an earthquake: everything stops, doors do as the plant file says. Then release it, and resume.
#   HOISTWAY=http://localhost:8080 ./emergency.sh fire "smoke in bay 2"
#   HOISTWAY=http://localhost:8080 ./emergency.sh --release fire "false alarm, seen" && curl -X POST $HOISTWAY/api/v1/controller/resume
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
path=/controller/emergency
if [[ ${1-} == --release ]]; then
  path+=/release
  shift
fi
usage "[--release] fire|earthquake REASON" "$@"

body=$(object kind="$1" reason="$2")
ask POST "$path" "$body"
echo
