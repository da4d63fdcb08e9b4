#!/usr/bin/env bash
# Stage a plant file as a new version; prints it with its number, then what differs and what stands in its way. Changes nothing yet.
#   HOISTWAY=http://localhost:8080 ./layout-stage.sh new.yaml "a port more"
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "FILE REASON" "$@"
[[ -r $1 ]] || { echo "$1: there is no such file that can be read" >&2; exit 1; }

answer=$(ask POST /layout/versions "" --data-binary "@$1" --header "Content-Type: application/yaml" --url-query "reason=$2") ||
  { echo "$answer"; exit 1; } # what is wrong with the plant
echo "$answer"
number=$(field number <<<"$answer")
ask GET "/layout/versions/$number/diff"
echo
ask GET "/layout/versions/$number/impact"
echo
