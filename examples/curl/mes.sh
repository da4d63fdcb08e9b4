#!/usr/bin/env bash
# An MES with curl: order a transfer, follow it to its end, and know where it is after a break.
#   mes.sh JOB_ID SOURCE DESTINATION          URL and KEY by HOISTWAY_URL and HOISTWAY_KEY
# It prints the events of the job, why it waits where it does, and at the end how it ended; a refusal with what would help.
set -euo pipefail
if [ $# -ne 3 ]; then
    echo "usage: $(basename "$0") JOB_ID SOURCE DESTINATION     (URL and KEY by HOISTWAY_URL and HOISTWAY_KEY)" >&2
    exit 2
fi
url=${HOISTWAY_URL:-http://127.0.0.1:8080}/api/v1
call=(curl --silent --show-error --max-time 40 --header "X-Actor: mes" --write-out '\n%{http_code}')
[ -z "${HOISTWAY_KEY:-}" ] || call+=(--header "Authorization: Bearer $HOISTWAY_KEY")

# json PROGRAM: run a line of Python over the JSON `it` of standard input.
json() { python3 -c "import json, sys
it = json.load(sys.stdin)
$1"; }

# ask URL [OPTION OF CURL...]: print the answer. What may pass by itself is asked again, six times in half a minute: no connection or a
# lost one, and the statuses 429, 502, 503 and 504. All else that is no answer is said with what would help, and ends the script.
ask() {
    local answer status code pause=1
    while true; do
        code=0
        answer=$("${call[@]}" "$@") || code=$?
        status=${answer##*$'\n'} answer=${answer%$'\n'*}
        case $code:$status in
        0:2??) printf '%s\n' "$answer" && return ;;
        # what curl calls: no such host (now), no connection, half an answer, no answer in time, none at all, lost
        0:429 | 0:502 | 0:503 | 0:504 | 6:* | 7:* | 18:* | 28:* | 52:* | 55:* | 56:*) ;;
        *) pause=32 ;;
        esac
        if ((pause > 16)); then
            json 'print("{status} {code}: {detail} {remedy}".format(**it))' <<<"$answer" 2>/dev/null ||
                echo "$1: ${answer:-no answer (curl $code, status $status)}"
            return 1
        fi >&2
        sleep "$pause"
        pause=$((pause * 2))
    done
}

# The id makes it safe to send again and again: the same id and body are the same job (201 the first time, then 200).
order=$(python3 -c 'import json, sys; print(json.dumps(dict(zip(("job_id", "source", "destination"), sys.argv[1:]))))' "$@")
ask "$url/jobs" --header 'Content-Type: application/json' --data-binary "$order"
job=$(python3 -c 'import sys, urllib.parse; print(urllib.parse.quote(sys.argv[1], safe=""))' "$1")

# Follow its events; after a lost connection, ask what is missing from the last number on.
after=0 told=""
while true; do
    # The state before the events: what happened until it was final is among them then.
    now=$(ask "$url/jobs/$job")
    state=$(json 'print(it["state"])' <<<"$now") why=$(json 'print(it["reason"])' <<<"$now")
    page=$(ask "$url/events?after=$after&job=$job&limit=100")
    while IFS=$'\t' read -r seq event vehicle result; do
        [ -n "$seq" ] || continue
        after=$seq
        echo "$seq $event $vehicle $result"
    done < <(json 'for e in it["items"]: print(e["seq"], e["event"], e["vehicle"] or "-", e["result"] or "-", sep="\t")' <<<"$page")
    case $state in completed | failed | cancelled | aborted) echo "$state"; break ;; esac
    [ -z "$why" ] || [ "$why" = "$told" ] || echo "$state: $why" >&2
    told=$why
    sleep 1
done
