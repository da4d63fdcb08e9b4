#!/usr/bin/env bash
# Bring the vehicle of the open session to its port, and into MANT: teaching needs both.
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"
at=$(api GET "/stations/$STATION" | field barcode)
body=$(object command=move barcode="$at" action=port)
api POST "/vehicles/$VEHICLE/commands" "$body" >/dev/null
wait_for "/vehicles/$VEHICLE" barcode "$at"
wait_for "/vehicles/$VEHICLE" activity idle
api POST "/vehicles/$VEHICLE/commands" '{"command": "stop"}' >/dev/null
wait_for "/vehicles/$VEHICLE" mode mant
echo "$VEHICLE stands at barcode $at in MANT; align the hoist over the port by hand"
