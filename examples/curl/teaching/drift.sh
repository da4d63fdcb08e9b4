#!/usr/bin/env bash
# Which ports and vehicles were last taught far from what held before? Limits in pulses: LIFT=300 ./drift.sh
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"
api GET "/teaching/drift?lift=${LIFT:-300}&shft=${SHFT:-100}&rota=${ROTA:-50}" |
  items 'print(row["name"], "drifted:", row["drift"], "in version", row["new"]["version"], "by", row["new"]["actor"])'
