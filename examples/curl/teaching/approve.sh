#!/usr/bin/env bash
# Look at every port and vehicle whose pulses a proposal changes, old -> new, then approve exactly what was looked at.
#   ./approve.sh [PROPOSAL]           (without a number: the newest about $STATION)
set -euo pipefail
source "$(dirname "$0")/_lib.sh"
proposal=${1:-$(newest)}
answer=$(api GET "/teaching/proposals/$proposal")
python3 -c '
import json, sys
shown = json.load(sys.stdin)
for change in shown["changes"]:
    old, new = change["old"], change["new"]
    print(change["station"], change["vehicle"], *(f"{axis} {old[axis]} -> {new[axis]}" for axis in old), change["beyond"])
print("drift:", shown["drift"] or "none")' <<<"$answer"
# If-Match: somebody else may have written meanwhile; then nothing is approved (412).
revision=$(field revision <<<"$answer")
answer=$(api POST "/teaching/proposals/$proposal/approve" '{"reason": "measured"}' --header "If-Match: \"$revision\"")
echo "proposal $proposal is $(field state <<<"$answer") as version $(field version <<<"$answer")"
