#!/usr/bin/env bash
# Restore a drive from a backup. First a dry run, which says what would be written; with a third word "really" it is done.
#   HOISTWAY=http://localhost:8080 ./drive-restore.sh AX1 12 [really]
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
drive=${1:?which drive?} backup=${2:?which backup?} really=${3:-}

field() { sed -n "s/.*\"$1\":\"\{0,1\}\([^\",}]*\).*/\1/p"; }

restore() {
    local operation answer
    answer=$(curl -sS --json "{\"backup\": $backup, \"dry_run\": $1}" -H "X-Actor: $ACTOR" \
        "$HOISTWAY/api/v1/drives/$drive/restore?wait=60")
    operation=$(field id <<<"$answer")
    while [ "$(field state <<<"$answer")" = running ]; do
        answer=$(curl -fsS "$HOISTWAY/api/v1/operations/$operation?wait=60")
    done
    echo "$answer"
    grep -q '"state":"done"' <<<"$answer"
}

restore true
[ "$really" != really ] || restore false
