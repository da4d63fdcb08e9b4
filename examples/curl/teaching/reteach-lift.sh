#!/usr/bin/env bash
# Teach LIFT alone again: the commonest correction. The other axes are carried over from the present version.
# At a real vehicle, bring the lifter to its height and press LIFT DEST TEACHING on the hand controller. At a simulated one
# (hoistway sim or demo --operator 8081) this script does it: OPERATOR=http://127.0.0.1:8081 LIFT=41120 ./reteach-lift.sh
set -euo pipefail
source "$(dirname "$0")/_lib.sh"
before=$(newest 2>/dev/null || true)
if [[ -n ${OPERATOR:-} ]]; then
  hands() { curl --silent --show-error --fail-with-body "$OPERATOR/hoists/$VEHICLE/$1" --data "$2" >/dev/null; }
  hands jog "{\"lift\": ${LIFT:?the height in pulses}}"
  hands teach '{"what": "lift_dest"}'
else
  echo "press LIFT DEST TEACHING on the hand controller of $VEHICLE"
fi
until [[ $(newest) != "$before" ]]; do sleep 0.5; done
proposal=$(newest)
# More axes may follow for ten seconds; then the set is what it is.
wait_for "/teaching/proposals/$proposal" state ready
answer=$(api GET "/teaching/proposals/$proposal")
echo "proposal $proposal: sent $(field raw <<<"$answer"), makes $(field result <<<"$answer")"
