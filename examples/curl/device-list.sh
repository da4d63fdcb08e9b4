#!/usr/bin/env bash
# List doors, buffers and chargers: state, who is in them or waits for them, what is wrong and what helps.
#   HOISTWAY=http://localhost:8080 ./device-list.sh
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"

ask GET /devices
echo
