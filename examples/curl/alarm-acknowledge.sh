#!/usr/bin/env bash
# Say that you know of an alarm; it goes on until its cause is gone.
#   HOISTWAY=http://localhost:8080 ./alarm-acknowledge.sh 17 "a wheel is worn"
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "NUMBER [NOTE]" "$@"

body=$(object note="${2-}")
ask POST "/alarms/$1/acknowledge" "$body"
echo
