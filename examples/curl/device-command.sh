#!/usr/bin/env bash
# Command a door (open, close) or a buffer (lock, unlock), and wait for what becomes of it. Prints the command as it ended.
#   HOISTWAY=http://localhost:8080 ./device-command.sh DOOR1 open
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "DEVICE COMMAND" "$@"
commands="/devices/$1/commands"

body=$(object command="$2")
answer=$(ask POST "$commands" "$body") || { echo "$answer"; exit 1; } # a problem says why
number=$(field cmd_id <<<"$answer")
if [[ -z $number ]]; then # there was nothing to send
  echo "$answer"
  exit
fi
while answer=$(api GET "$commands/$number") && grep -Eq '"state":"(open|unknown)"' <<<"$answer"; do sleep 0.2; done
echo "$answer"
grep -Eq '"state":"(done|settled_done)"' <<<"$answer"
