#!/usr/bin/env bash
# Let a version be the active one, and wait until it is; a former one: roll back. WAIT=true: once nothing stands in its way.
#   HOISTWAY=http://localhost:8080 ./layout-activate.sh 2 "it is built"
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}" "${WAIT:=false}"
number=${1:?which version?} reason=${2:?why?}
version="$HOISTWAY/api/v1/layout/versions/$number"

curl -sS --fail-with-body --json "{\"reason\": \"$reason\", \"wait\": $WAIT}" -H "X-Actor: $ACTOR" "$version/activate"
echo
state=awaited
while [[ $state == awaited ]]; do
  sleep 0.5
  # While the controller changes over, nobody answers: that passes by itself, a refusal does not.
  state=$(curl -sS --fail-with-body --retry 30 --retry-connrefused --retry-delay 1 "$version" | sed -n 's/.*"state":"\([a-z]*\)".*/\1/p')
done
echo "version $number is $state"
[[ $state == active ]]
