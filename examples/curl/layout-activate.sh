#!/usr/bin/env bash
# Let a version be the active one, and wait until it is; a former one: roll back. WAIT=true: once nothing stands in its way.
#   HOISTWAY=http://localhost:8080 ./layout-activate.sh 2 "it is built"
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "VERSION REASON" "$@"
version="/layout/versions/$1"

body=$(object reason="$2" wait:="${WAIT:-false}")
ask POST "$version/activate" "$body"
echo
state=awaited
while [[ $state == awaited ]]; do
  sleep 0.5
  # While the controller changes over, nobody answers: that passes by itself, a refusal does not.
  state=$(api GET "$version" "" --retry 30 --retry-connrefused --retry-delay 1 | field state)
done
echo "version $1 is $state"
[[ $state == active ]]
