#!/usr/bin/env bash
# Print a place as JSON, as the other closure scripts send it.
#   ./closure-place.sh barcode 1203 | edge 1203 1204 | stretch 1203 1210 | zone merge-3 | station STK01-P02
set -euo pipefail
kind=${1:?barcode, edge, stretch, zone or station?} name=${2:?which one?}
case $kind in
  barcode) echo "{\"kind\": \"barcode\", \"barcodes\": [\"$name\"]}" ;;
  edge | stretch) echo "{\"kind\": \"$kind\", \"from\": \"$name\", \"to\": \"${3:?to which barcode?}\"}" ;;
  zone | station) echo "{\"kind\": \"$kind\", \"$kind\": \"$name\"}" ;;
  *) echo "no such kind of place: $kind" >&2; exit 2 ;;
esac
