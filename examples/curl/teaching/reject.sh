#!/usr/bin/env bash
# Make nothing of a proposal; its raw events stay for ever.
#   ./reject.sh "taught askew" [PROPOSAL]
set -euo pipefail
source "$(dirname "$0")/_lib.sh"
proposal=${2:-$(newest)}
answer=$(api POST "/teaching/proposals/$proposal/reject" "{\"reason\": \"${1:?why}\"}")
echo "proposal $proposal is $(field state <<<"$answer")"
