#!/usr/bin/env bash
# The versions of the plant, newest first: who, when, why, and which one runs.
#   HOISTWAY=http://localhost:8080 ./layout-versions.sh
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}"

curl -fsS "$HOISTWAY/api/v1/layout/versions"
echo
