#!/usr/bin/env bash
# Close a place: nobody comes in, those inside drive out. PURPOSE=work: people are there, so it never opens by itself.
#   HOISTWAY=http://localhost:8080 ./closure-close.sh "rail change" stretch 1065 1069
#   HOISTWAY=http://localhost:8080 PURPOSE=work ./closure-close.sh "new motor" station STK01-P02
#   HOISTWAY=http://localhost:8080 MINUTES=30 ./closure-close.sh "crowded" barcode 1067
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "REASON KIND NAME [TO]" "$@"
place=$("$(dirname -- "$0")/closure-place.sh" "${@:2}")

body=$(object place:="$place" reason="$1" purpose="${PURPOSE:-traffic}" minutes:="${MINUTES:-null}")
ask POST /closures "$body"
echo
