#!/usr/bin/env bash
# Export the taught values as files for a spreadsheet or for git: what holds now, and with HISTORY=true all that ever held.
#   ./export.sh DIRECTORY             (made if it is not there; without one: here)
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "[DIRECTORY]" "$@"
directory=${1:-.}
mkdir -p -- "$directory"
for what in dests offsets; do
  # An answer at first: a refusal is no file.
  rows=$(api GET "/teaching/$what?format=csv&history=${HISTORY:-false}")
  printf '%s\n' "$rows" >"$directory/$what.csv"
  echo "$directory/$what.csv: $(($(wc -l <"$directory/$what.csv") - 1)) rows"
done
