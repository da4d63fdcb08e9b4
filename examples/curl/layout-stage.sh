#!/usr/bin/env bash
# Stage a plant file as a new version; prints it with its number, then what differs and what stands in its way. Changes nothing yet.
#   HOISTWAY=http://localhost:8080 ./layout-stage.sh new.yaml "a port more"
set -euo pipefail
: "${HOISTWAY:=http://localhost:8080}" "${ACTOR:=$(id -un)}"
file=${1:?which plant file?} reason=${2:?why?}
versions="$HOISTWAY/api/v1/layout/versions"

answer=$(curl -sS --fail-with-body --data-binary "@$file" -H "Content-Type: application/yaml" -H "X-Actor: $ACTOR" \
  --url-query "reason=$reason" "$versions")
echo "$answer"
number=$(sed -n 's/.*"number":\([0-9]*\).*/\1/p' <<<"$answer")
curl -fsS "$versions/$number/diff"
echo
curl -fsS "$versions/$number/impact"
echo
