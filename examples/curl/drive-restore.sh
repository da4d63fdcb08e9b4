#!/usr/bin/env bash
# Restore a drive from a backup. First a dry run, which says what would be written; with a third word "really" it is done.
#   HOISTWAY=http://localhost:8080 ./drive-restore.sh AX1 12 [really]
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DRIVE BACKUP [really]" "$@"
drive=$1 backup=$2 really=${3:-}

restore() {
    local operation answer body
    body=$(object backup:="$backup" dry_run:="$1")
    answer=$(api POST "/drives/$drive/restore?wait=60" "$body")
    operation=$(field id <<<"$answer")
    while [ "$(field state <<<"$answer")" = running ]; do
        answer=$(api GET "/operations/$operation?wait=60")
    done
    echo "$answer"
    grep -q '"state":"done"' <<<"$answer"
}

restore true
[ "$really" != really ] || restore false
