#!/usr/bin/env bash
# List the drives of the plant: id, mode, error, whether they move, who has locked them out.
#   HOISTWAY=http://localhost:8080 ./drive-list.sh
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"

ask GET /drives
echo
ask GET /links
echo
