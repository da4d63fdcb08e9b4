#!/usr/bin/env bash
# Watch teaching as it happens, from now on (SECONDS_LONG: how long). The WebSocket /api/v1/live?topics=teaching has the same as objects.
set -euo pipefail
source "$(dirname "$0")/_lib.sh"
curl --silent --no-buffer --max-time "${SECONDS_LONG:-3600}" "$HOISTWAY/api/v1/events/stream${AFTER:+?after=$AFTER}" |
  sed -un 's/^data: \(.*"event":"Teaching.*\)/\1/p' || true
