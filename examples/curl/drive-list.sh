#!/usr/bin/env bash
# List the drives of the plant: id, mode, error, whether they move, who has locked them out.
#   HOISTWAY=http://localhost:8080 ./drive-list.sh
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}"

curl -fsS "$HOISTWAY/api/v1/drives"
echo
curl -fsS "$HOISTWAY/api/v1/links"
echo
