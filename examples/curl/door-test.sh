#!/usr/bin/env bash
# Test a door: open it, close it, show its last commands and packets. Stops at the first thing that does not work.
#   HOISTWAY=http://localhost:8080 ./door-test.sh DOOR1
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}"
door=${1:?which door?} here=$(dirname "$0")

"$here/device-command.sh" "$door" open
"$here/device-command.sh" "$door" close
curl -fsS "$HOISTWAY/api/v1/devices/$door/commands?limit=2"
echo
curl -fsS "$HOISTWAY/api/v1/devices/$door/frames"
echo
