#!/usr/bin/env bash
# Export the taught values as files for a spreadsheet or for git: what holds now, and with HISTORY=true all that ever held.
#   ./export.sh DIRECTORY
set -euo pipefail
source "$(dirname "$0")/_lib.sh"
for what in dests offsets; do
  api GET "/teaching/$what?format=csv&history=${HISTORY:-false}" '' --output "${1:-.}/$what.csv"
  echo "${1:-.}/$what.csv: $(($(wc -l <"${1:-.}/$what.csv") - 1)) rows"
done
