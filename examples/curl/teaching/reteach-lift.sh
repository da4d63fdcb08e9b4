#!/usr/bin/env bash
# Teach LIFT alone again: the commonest correction. The other axes are carried over from the present version.
# At a real vehicle, bring the lifter to its height and press LIFT DEST TEACHING on the hand controller. At a simulated one
# (hoistway sim or demo --operator 8081) this script does it: OPERATOR=http://127.0.0.1:8081 LIFT=41120 ./reteach-lift.sh
# It waits for ten minutes (PATIENCE, in seconds), and says every half minute (REMIND) what for.
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"
before=$(newest)
if [[ -n ${OPERATOR:-} ]]; then
  [[ -n ${LIFT:-} ]] || { echo "LIFT is not set: the height in pulses to which the simulated hoist is jogged" >&2; exit 2; }
  hands() {
    local answer
    answer=$(curl --silent --show-error --fail-with-body "$OPERATOR/hoists/$VEHICLE/$1" --data "$2") ||
      { echo "$1 at $OPERATOR: ${answer:-no answer}" >&2; return 1; }
  }
  body=$(object lift:="$LIFT")
  hands jog "$body"
  hands teach '{"what": "lift_dest"}'
else
  echo "press LIFT DEST TEACHING on the hand controller of $VEHICLE"
fi
patience=${PATIENCE:-600} remind=${REMIND:-30} begun=$SECONDS told=0
while proposal=$(newest); [[ $proposal == "$before" ]]; do
  waited=$((SECONDS - begun))
  if ((waited - told >= remind)); then
    echo "still waiting for LIFT DEST TEACHING of $VEHICLE at $STATION; ends after $patience s" >&2
    told=$waited
  fi
  if ((waited >= patience)); then
    echo "nothing was taught at $STATION in $patience s (PATIENCE): does $VEHICLE stand there in MANT? See history.sh" >&2
    exit 1
  fi
  sleep 0.5
done
# More axes may follow for ten seconds; then the set is what it is.
wait_for "/teaching/proposals/$proposal" state ready
answer=$(api GET "/teaching/proposals/$proposal")
echo "proposal $proposal: sent $(field raw <<<"$answer"), makes $(field result <<<"$answer")"
