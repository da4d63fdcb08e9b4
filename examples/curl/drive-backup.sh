#!/usr/bin/env bash
# Back a drive up, and save the backup as CSV. Prints the backup's number.
#   HOISTWAY=http://localhost:8080 ./drive-backup.sh AX1 "before tuning" backup.csv
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DRIVE [NOTE] [FILE]" "$@"
file=${3:-$1.csv}

body=$(object note="${2-}")
answer=$(api POST "/drives/$1/backups?wait=60" "$body")
backup=$(field result.backup <<<"$answer" 2>/dev/null) || { echo "$answer" >&2; exit 1; } # it failed, and says why
ask GET "/drives/$1/backups/$backup?format=csv" "" --output "$file" || { cat -- "$file" >&2; exit 1; }
echo "$backup"
