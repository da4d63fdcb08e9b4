#!/usr/bin/env bash
# Back a drive up, and save the backup as CSV. Prints the backup's number.
#   HOISTWAY=http://localhost:8080 ./drive-backup.sh AX1 "before tuning" backup.csv
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
drive=${1:?which drive?} note=${2:-} file=${3:-$drive.csv}

field() { sed -n "s/.*\"$1\":\"\{0,1\}\([^\",}]*\).*/\1/p"; }

answer=$(curl -fsS --json "{\"note\": \"$note\"}" -H "X-Actor: $ACTOR" "$HOISTWAY/api/v1/drives/$drive/backups?wait=60")
backup=$(field backup <<<"$answer")
[ -n "$backup" ] || { echo "$answer" >&2; exit 1; }
curl -fsS -o "$file" "$HOISTWAY/api/v1/drives/$drive/backups/$backup?format=csv"
echo "$backup"
