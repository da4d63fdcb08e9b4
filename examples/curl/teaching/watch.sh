#!/usr/bin/env bash
# Watch teaching as it happens, from now on (SECONDS_LONG: how long). The WebSocket /api/v1/live?topics=teaching has the same as objects.
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"
code=0
# A line that begins with a brace is a refusal.
keyed --silent --fail-with-body --no-buffer --max-time "${SECONDS_LONG:-3600}" "$HOISTWAY/api/v1/events/stream${AFTER:+?after=$AFTER}" |
  sed -un -e 's/^data: \(.*"event":"Teaching.*\)/\1/p' -e '/^{/p' || code=${PIPESTATUS[0]}
[[ $code == 0 || $code == 28 ]] || { echo "$HOISTWAY: no events (curl ends with $code)" >&2; exit 1; } # 28: the time is over
