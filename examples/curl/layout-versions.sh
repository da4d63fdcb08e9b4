#!/usr/bin/env bash
# The versions of the plant, newest first: who, when, why, and which one runs.
#   HOISTWAY=http://localhost:8080 ./layout-versions.sh
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"

ask GET /layout/versions
echo
