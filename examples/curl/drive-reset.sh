#!/usr/bin/env bash
# Show the error of a drive with its meaning and remedy, reset it, and show the status after that.
#   HOISTWAY=http://localhost:8080 ./drive-reset.sh AX1
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DRIVE" "$@"

ask GET "/drives/$1"
echo
ask POST "/drives/$1/keys?wait=10" '{"key": "stop_reset"}'
echo
ask POST "/drives/$1/status?wait=10"
echo
