#!/usr/bin/env bash
# Test a door: open it, close it, show its last commands and packets. Stops at the first thing that does not work.
#   HOISTWAY=http://localhost:8080 ./door-test.sh DOOR1
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DOOR" "$@"
here=$(dirname -- "$0")

"$here/device-command.sh" "$1" open
"$here/device-command.sh" "$1" close
ask GET "/devices/$1/commands?limit=2"
echo
ask GET "/devices/$1/frames"
echo
