#!/usr/bin/env bash
# What would closing a place do? Stations, vehicles, jobs, and how much longer routes get. Changes nothing.
#   HOISTWAY=http://localhost:8080 ./closure-preview.sh barcode 1203
#   HOISTWAY=http://localhost:8080 ./closure-preview.sh stretch 1203 1210
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}"
place=$("$(dirname "$0")/closure-place.sh" "$@")

curl -fsS --json "{\"place\": $place}" "$HOISTWAY/api/v1/closures/preview"
echo
