#!/usr/bin/env bash
# Import taught values from a file as exported. First a dry run that says what would become of each row; with CONFIRM=yes the
# real one: all rows, or none if one is wrong.
#   ./import.sh dests.csv         (offsets.csv: the values of vehicles)
set -euo pipefail
source "$(dirname "$0")/_lib.sh"
what=$(basename "$1" .csv)
send() { api POST "/teaching/$what/import?dry_run=$1" '' --header 'Content-Type: text/csv' --data-binary "@$2"; }
answer=$(send true "$1")
python3 -c '
import json, sys
for row in json.load(sys.stdin)["items"]:
    if row["fate"] != "same":
        print("line", row["line"], row["name"], row["fate"], row["detail"], row["remedy"])' <<<"$answer"
echo "dry run: $(field counts <<<"$answer")"
[[ ${CONFIRM:-no} == yes ]] || exit 0
answer=$(send false "$1")
echo "imported: $(field counts <<<"$answer")"
