#!/usr/bin/env bash
# What would this vehicle be sent at this port, and from which rows? Nothing is sent.
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"
answer=$(api GET "/teaching/targets/$STATION/$VEHICLE")
echo "$VEHICLE at $STATION: shft $(field shft <<<"$answer"), rota $(field rota <<<"$answer"), lift $(field lift <<<"$answer")"
refusal=$(field refusal <<<"$answer")
[[ -z $refusal ]] || { echo "a job would be refused: $refusal"; exit 0; }
echo "from DEST version $(field dest.version <<<"$answer") by $(field dest.actor <<<"$answer")"
if [[ $(field reference <<<"$answer") == True ]]; then
  echo "and no OFFSET: $VEHICLE is a reference vehicle, whose OFFSET is zero by declaration"
  exit
fi
echo "and OFFSET version $(field offset.version <<<"$answer") by $(field offset.actor <<<"$answer")"
