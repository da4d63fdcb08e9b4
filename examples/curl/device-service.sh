#!/usr/bin/env bash
# Take a charger, buffer or door out of service, or put it back.
#   HOISTWAY=http://localhost:8080 ./device-service.sh CHARGER1 "no current"
#   HOISTWAY=http://localhost:8080 ./device-service.sh CHARGER1
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DEVICE [REASON]" "$@"

body=$(object in_service:="$([[ -z ${2-} ]] && echo true || echo false)" reason="${2-}")
ask PUT "/devices/$1/service" "$body"
echo
