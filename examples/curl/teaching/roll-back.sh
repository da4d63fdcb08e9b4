#!/usr/bin/env bash
# Let an older version of the port hold again. It becomes a new version, so that nothing is ever lost.
#   ./roll-back.sh 1 "the new one is askew"
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "VERSION REASON" "$@"
present=$(api GET "/stations/$STATION/dest" '' --include | tr -d '\r' | sed -n 's/^etag: //Ip')
body=$(object version:="$1" reason="$2")
answer=$(api POST "/stations/$STATION/dest/rollback" "$body" --header "If-Match: $present")
echo "version $(field new.version <<<"$answer") restores version $(field new.restores <<<"$answer")"
echo "before -> after: $(field changes <<<"$answer")"
