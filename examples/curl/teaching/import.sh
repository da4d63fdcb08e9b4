#!/usr/bin/env bash
# Import taught values from a file as exported. First a dry run that says what would become of each row; with CONFIRM=yes the
# real one: all rows, or none if one is wrong. Its first line says whose values they are, those of ports (column `station`) or those of
# vehicles (column `vehicle`), whatever the file is called and wherever it lies.
#   ./import.sh dests.csv
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "FILE.csv" "$@"
file=$1
[[ $file == /* ]] || file=./$file # a name may begin with a dash
[[ -f $file && -r $file ]] || { echo "$1: there is no such file that can be read" >&2; exit 1; }
columns=$(head -n 1 -- "$file" | tr -d '" \r\357\273\277' | tr '[:upper:]' '[:lower:]')
case ",$columns," in
  *,station,*) what=dests ;;
  *,vehicle,*) what=offsets ;;
  *) echo "$1: its first line names no column station (ports) or vehicle: export.sh writes files as they have to be" >&2; exit 1 ;;
esac
send() { api POST "/teaching/$what/import?dry_run=$1" '' --header 'Content-Type: text/csv' --data-binary "@$file"; }
answer=$(send true)
items 'if row["fate"] != "same": print("line", row["line"], row["name"], row["fate"], row["detail"], row["remedy"])' <<<"$answer"
echo "dry run of $what: $(field counts <<<"$answer")"
[[ ${CONFIRM:-no} == yes ]] || exit 0
answer=$(send false)
echo "imported: $(field counts <<<"$answer")"
