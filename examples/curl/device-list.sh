#!/usr/bin/env bash
# List doors, buffers and chargers: state, who is in them or waits for them, what is wrong and what helps.
#   HOISTWAY=http://localhost:8080 ./device-list.sh
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}"

curl -fsS "$HOISTWAY/api/v1/devices"
echo
