# What every script here uses: where the controller is, who asks, and how to read an answer. Source it; it does nothing itself.
HOISTWAY=${HOISTWAY:-http://127.0.0.1:8080} # where `hoistway serve` or `make run` answers
ACTOR=${ACTOR:-${USER:-maintenance}}        # your name: it stands in the audit
STATION=${STATION:-ETCH01-P1}               # the port that is taught
VEHICLE=${VEHICLE:-V001}                    # the vehicle that teaches it

# api METHOD PATH [JSON] [more options of curl]: ask; a refusal is printed with what would help, and ends the script.
api() {
  local method=$1 path=$2 body=${3:-} answer
  shift $(($# < 3 ? $# : 3))
  answer=$(curl --silent --fail-with-body --max-time 60 --request "$method" "$HOISTWAY/api/v1$path" \
    --header "X-Actor: $ACTOR" ${body:+--header 'Content-Type: application/json' --data "$body"} "$@") ||
    { echo "$method $path: ${answer:-no answer}" >&2; return 1; }
  printf '%s' "$answer"
}

# field NAME: print one field of the JSON on standard input; names of nested ones are joined by dots.
field() {
  python3 -c '
import json, sys
value = json.load(sys.stdin)
for key in sys.argv[1].split("."):
    value = value[int(key)] if isinstance(value, list) else value[key]
print("" if value is None else value)' "$1"
}

# wait_for PATH NAME VALUE: ask again and again, for two minutes at most, until a field has that value, or can have it no more.
wait_for() {
  local now="" end=$((SECONDS + 120))
  while ((SECONDS < end)); do
    now=$(api GET "$1" | field "$2") && [[ $now == "$3" ]] && return
    [[ $now =~ ^(failed|not_sent|settled_not_done)$ ]] && break
    sleep 0.5
  done
  echo "$1: $2 is '$now', not '$3'" >&2
  return 1
}

# session: print the number of the open session of $STATION.
session() { api GET "/teaching/sessions?state=open&station=$STATION&limit=1" | field items.0.id; }

# newest: print the number of the newest proposal about $STATION.
newest() { api GET "/teaching/proposals?station=$STATION&limit=1" | field items.0.id; }
