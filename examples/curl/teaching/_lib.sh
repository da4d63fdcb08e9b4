# What the scripts of teaching use besides what all scripts do: whose port and vehicle. Source it; it does nothing itself.
source "$(dirname -- "${BASH_SOURCE[0]}")/../_lib.sh"
STATION=${STATION:-ETCH01-P1} # the port that is taught
VEHICLE=${VEHICLE:-V001}      # the vehicle that teaches it

# wait_for PATH NAME VALUE: ask again and again, for two minutes at most, until a field has that value, or can have it no more.
wait_for() {
  local now="" end=$((SECONDS + 120))
  while ((SECONDS < end)); do
    now=$(api GET "$1" | field "$2") || return 1
    [[ $now != "$3" ]] || return 0
    [[ $now =~ ^(failed|not_sent|settled_not_done)$ ]] && break
    sleep 0.5
  done
  echo "$1: $2 is '$now', not '$3'" >&2
  return 1
}

# first: print the number of the first of a list on standard input; nothing for an empty list.
first() { items 'print(row["id"]); break'; }

# session: print the number of the open session of $STATION. Fails, and says so, if there is none.
session() {
  local number
  number=$(api GET "/teaching/sessions?state=open&station=$STATION&limit=1" | first) || return 1
  [[ -n $number ]] || { echo "no open session for $STATION: open-session.sh first" >&2; return 1; }
  echo "$number"
}

# newest: print the number of the newest proposal about $STATION; nothing if there is none.
newest() { api GET "/teaching/proposals?station=$STATION&limit=1" | first; }

# proposal [NUMBER]: print that number, or that of the newest proposal about $STATION. Fails, and says so, if there is none.
proposal() {
  local number=${1-}
  [[ -n $number ]] || number=$(newest) || return 1
  [[ -n $number ]] || { echo "no proposal about $STATION: teach-station.sh or reteach-lift.sh first" >&2; return 1; }
  echo "$number"
}
