#!/usr/bin/env bash
# Ask the vehicle for its three axes (PORT DEST TEACHING), and show what the port would become.
# With WHAT=offset (PORT OFFSET TEACHING) the port is the reference, and the vehicle's own OFFSET is taught.
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"
number=$(session)
before=$(newest)
body=$(object what="${WHAT:-dest}")
command=$(api POST "/teaching/sessions/$number/start" "$body" | field cmd_id)
wait_for "/vehicles/$VEHICLE/commands/$command" state done
proposal=$(newest)
[[ $proposal != "$before" ]] || { echo "the vehicle sent nothing" >&2; exit 1; }
answer=$(api GET "/teaching/proposals/$proposal")
echo "proposal $proposal is $(field state <<<"$answer"): sent $(field raw <<<"$answer"), makes $(field result <<<"$answer")"
echo "warnings: $(field warnings <<<"$answer")"
