#!/usr/bin/env bash
# Make nothing of a proposal; its raw events stay for ever.
#   ./reject.sh "taught askew" [PROPOSAL]
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "REASON [PROPOSAL]" "$@"
proposal=$(proposal "${2-}")
body=$(object reason="$1")
answer=$(api POST "/teaching/proposals/$proposal/reject" "$body")
echo "proposal $proposal is $(field state <<<"$answer")"
