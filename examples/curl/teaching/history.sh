#!/usr/bin/env bash
# What was taught at this port: its versions, every set of events and what became of it, and the raw events themselves.
set -euo pipefail
source "$(dirname "$0")/_lib.sh"
api GET "/stations/$STATION/dest" | python3 -c '
import json, sys
for row in json.load(sys.stdin)["items"]:
    print("version", row["version"], row["shft"], row["rota"], row["lift"], row["source"], row["actor"], row["reason"])'
api GET "/teaching/proposals?station=$STATION" | python3 -c '
import json, sys
for row in json.load(sys.stdin)["items"]:
    print("proposal", row["id"], row["side"], "by", row["vehicle"], row["state"], row["why"], row["reason"])'
api GET "/teaching/events?vehicle=$VEHICLE" | python3 -c '
import json, sys
for row in json.load(sys.stdin)["items"]:
    print("event", row["number"], row["at"], row["code"], row["axis"], row["position"], "at", row["barcode"])'
