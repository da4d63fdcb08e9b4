#!/usr/bin/env bash
# End a closure by its number; one for people's work is ended by its owner, or by two others one after the other.
#   HOISTWAY=http://localhost:8080 ./closure-open.sh 3 "rail is back"
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "NUMBER [REASON]" "$@"

body=$(object reason="${2-}")
ask POST "/closures/$1/open" "$body"
echo
