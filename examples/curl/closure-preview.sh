#!/usr/bin/env bash
# What would closing a place do? Stations, vehicles, jobs, and how much longer routes get. Changes nothing.
#   HOISTWAY=http://localhost:8080 ./closure-preview.sh barcode 1067
#   HOISTWAY=http://localhost:8080 ./closure-preview.sh stretch 1065 1069
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "KIND NAME [TO]" "$@"
place=$("$(dirname -- "$0")/closure-place.sh" "$@")

body=$(object place:="$place")
ask POST /closures/preview "$body"
echo
