#!/usr/bin/env bash
# Bring the vehicle home and back to AUTO, and open the port to jobs again.
# With ABANDON=true, what the session has taught and nobody has approved is rejected.
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"
number=$(session)
for command in go_home auto; do
  body=$(object command="$command")
  sent=$(api POST "/vehicles/$VEHICLE/commands" "$body" | field cmd_id)
  wait_for "/vehicles/$VEHICLE/commands/$sent" state done
done
body=$(object abandon:="${ABANDON:-false}")
answer=$(api POST "/teaching/sessions/$number/close" "$body")
echo "session $number is $(field state <<<"$answer")"
