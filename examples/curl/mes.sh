#!/usr/bin/env bash
# An MES with curl: order a transfer, follow it to its end, and know where it is after a break.
#   mes.sh JOB_ID SOURCE DESTINATION          URL and KEY by HOISTWAY_URL and HOISTWAY_KEY
set -euo pipefail
url=${HOISTWAY_URL:-http://127.0.0.1:8080}/api/v1
job=$1 source=$2 destination=$3
call=(curl --silent --show-error --fail-with-body --header "X-Actor: mes")
[ -z "${HOISTWAY_KEY:-}" ] || call+=(--header "Authorization: Bearer $HOISTWAY_KEY")

# The id makes it safe to send again and again: the same id and body are the same job (201 the first time, then 200).
"${call[@]}" --retry 5 --retry-all-errors "$url/jobs" --header 'Content-Type: application/json' \
    --data "{\"job_id\": \"$job\", \"source\": \"$source\", \"destination\": \"$destination\"}"
echo

# Follow its events; after a lost connection, ask what is missing from the last number on.
after=0
while true; do
    # The state before the events: what happened until it was final is among them then.
    state=$("${call[@]}" --retry 5 --retry-all-errors "$url/jobs/$job" | python3 -c 'import json, sys; print(json.load(sys.stdin)["state"])')
    page=$("${call[@]}" --retry 5 --retry-all-errors "$url/events?after=$after&job=$job&limit=100")
    while IFS=$'\t' read -r seq event vehicle result; do
        [ -n "$seq" ] || continue
        after=$seq
        echo "$seq $event $vehicle $result"
    done < <(python3 -c 'import json, sys
for e in json.load(sys.stdin)["items"]: print(e["seq"], e["event"], e["vehicle"] or "-", e["result"] or "-", sep="\t")' <<<"$page")
    case $state in completed | failed | cancelled | aborted) echo "$state"; break ;; esac
    sleep 1
done
