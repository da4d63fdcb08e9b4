#!/usr/bin/env bash
# Print a place as JSON, as the other closure scripts send it.
#   ./closure-place.sh barcode 1067 | edge 1066 1067 | stretch 1065 1069 | zone M-A-PARK | station STK01-P02
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "KIND NAME [TO]" "$@"
case $1 in
  barcode)
    barcodes=$(list "$2")
    object kind=barcode barcodes:="$barcodes"
    ;;
  edge | stretch)
    usage "$1 FROM TO" "$@"
    object kind="$1" from="$2" to="$3"
    ;;
  zone | station) object kind="$1" "$1=$2" ;;
  *) echo "no such kind of place: $1; barcode, edge, stretch, zone or station" >&2; exit 2 ;;
esac
