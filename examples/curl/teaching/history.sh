#!/usr/bin/env bash
# What was taught at this port: its versions, every set of events and what became of it, and the raw events themselves.
set -euo pipefail
source "$(dirname -- "$0")/_lib.sh"
usage "" "$@"
api GET "/stations/$STATION/dest" |
  items 'print("version", row["version"], row["shft"], row["rota"], row["lift"], row["source"], row["actor"], row["reason"])'
api GET "/teaching/proposals?station=$STATION" |
  items 'print("proposal", row["id"], row["side"], "by", row["vehicle"], row["state"], row["why"], row["reason"])'
api GET "/teaching/events?vehicle=$VEHICLE" |
  items 'print("event", row["number"], row["at"], row["code"], row["axis"], row["position"], "at", row["barcode"])'
