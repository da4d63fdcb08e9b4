#!/usr/bin/env bash
# Look at every port and vehicle whose pulses a proposal changes, old -> new, then approve exactly what was looked at.
#   ./approve.sh [PROPOSAL]           (without a number: the newest about $STATION)
# At a terminal it asks before it approves. REASON is kept with the version.
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "[PROPOSAL]" "$@"
proposal=$(proposal "${1-}")
answer=$(api GET "/teaching/proposals/$proposal")
python3 -c '
import json, sys
shown = json.load(sys.stdin)
for change in shown["changes"]:
    old, new = change["old"], change["new"]
    before = {axis: "-" if pulses is None else pulses for axis, pulses in old.items()}
    print(change["station"], change["vehicle"], *(f"{axis} {before[axis]} -> {new[axis]}" for axis in old), change["beyond"])
print("drift:", shown["drift"] or "none")' <<<"$answer"
if [ -t 0 ]; then
  read -rp "approve this? [y/N] " sure
  [ "$sure" = y ] || { echo "proposal $proposal is left as it is"; exit 1; }
fi
# If-Match: somebody else may have written meanwhile; then nothing is approved (412).
revision=$(field revision <<<"$answer")
body=$(object reason="${REASON:-measured}")
answer=$(api POST "/teaching/proposals/$proposal/approve" "$body" --header "If-Match: \"$revision\"")
echo "proposal $proposal is $(field state <<<"$answer") as version $(field version <<<"$answer")"
