#!/usr/bin/env bash
# What is closed now, by whom and why, and who is still inside.
#   HOISTWAY=http://localhost:8080 ./closure-list.sh
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}"

curl -fsS "$HOISTWAY/api/v1/closures"
echo
