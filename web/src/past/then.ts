/** What is recorded of a vehicle is what a map shows; the rest is filled with what says nothing. */
import type { Vehicle } from "../types";

const LINK = { up: true, since: "", reason: "", frames_in: 0, frames_out: 0, garbled: 0, resends: 0, duplicates: 0, round_trip_ms: null };
const BLANK: Vehicle = {
  id: "",
  dev_id: 0,
  dialect: "",
  address: "",
  state: "",
  activity: "",
  service: "",
  link: LINK,
  mode: null,
  oper: null,
  code: null,
  code_name: "",
  loaded: null,
  carrier: null,
  barcode: null,
  dist: null,
  seq: null,
  status1: null,
  status2: null,
  bits: [],
  job: null,
  goal: null,
  waiting: "",
  waits_for: null,
  granted: [],
  covered: [],
  hold: null,
  lockout: null,
  seen: null,
  parked: false,
};
const GONE = { ...LINK, up: false };

/** A vehicle as it was recorded. */
export function ofThen(id: string, now: Record<string, unknown>): Vehicle {
  return { ...BLANK, ...now, id, link: now["activity"] === "absent" ? GONE : LINK };
}

/** One that was shown, with what has changed of it: made many thousand times a second. */
export function changedOf(before: Vehicle, now: Record<string, unknown>): Vehicle {
  return { ...before, ...now, link: (now["activity"] ?? before.activity) === "absent" ? GONE : LINK };
}
