#!/usr/bin/env bash
# What is closed now, by whom and why, and who is still inside.
#   HOISTWAY=http://localhost:8080 ./closure-list.sh
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"

ask GET /closures
echo
