#!/usr/bin/env bash
# Command a door (open, close) or a buffer (lock, unlock), and wait for what becomes of it. Prints the command as it ended.
#   HOISTWAY=http://localhost:8080 ./device-command.sh DOOR1 open
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
device=${1:?which device?} command=${2:?open, close, lock or unlock?}
commands="$HOISTWAY/api/v1/devices/$device/commands"

answer=$(curl -sS --json "{\"command\": \"$command\"}" -H "X-Actor: $ACTOR" "$commands")
number=$(sed -n 's/.*"cmd_id":"\([0-9a-f]*\)".*/\1/p' <<<"$answer")
if [[ -z $number ]]; then # a problem says why; null says that there was nothing to send
  echo "$answer"
  grep -q '"cmd_id":null' <<<"$answer"
  exit
fi
while answer=$(curl -fsS "$commands/$number") && grep -Eq '"state":"(open|unknown)"' <<<"$answer"; do sleep 0.2; done
echo "$answer"
grep -Eq '"state":"(done|settled_done)"' <<<"$answer"
