/** What an audit row keeps of a request, field by field, told in words: `vehicle V5, what stop` names its fields in English. Pure. */

/** A field of a request -> the page's word for it. */
export const FIELDS = {
  vehicle: "vehicle",
  station: "at_station",
  stations: "stations",
  drive: "drive",
  device: "device",
  job: "job",
  carrier: "carrier",
  place: "place",
  zone: "close_zone",
  source: "source",
  destination: "destination",
  priority: "priority",
  reason: "reason",
  what: "what",
  act: "what",
  command: "what",
  key: "field_key",
  kind: "kind",
  barcode: "barcode",
  action: "stop_action",
  present: "present",
  reserved: "reserved",
  out_of_service: "out_of_service",
  by_person: "field_by_person",
  any_vehicle: "field_any_vehicle",
  forgotten: "field_forgotten",
  walked: "field_walked",
  inputs: "inputs",
  parameters: "parameters",
  parameter: "parameters",
  note: "note",
  purpose: "purpose",
  stop: "field_stop",
  side: "kind",
  tag: "tag",
  position: "state",
  line: "on_line",
  idempotency_key: "field_idempotency_key",
  fallbacks: "field_fallbacks",
  text: "field_text",
  alarm: "field_alarm",
  pickup: "field_pickup",
  target: "field_target",
  confirmed: "field_confirmed",
  verdict: "field_verdict",
  pulses: "field_pulses",
  expected: "field_expected",
  raw: "field_raw",
  value: "field_value",
  raw_access: "field_raw_access",
  other: "field_other",
  model: "field_model",
  dry_run: "field_dry_run",
  turn: "field_turn",
  operation: "field_operation",
  session: "field_session",
  abandon: "field_abandon",
  proposal: "field_proposal",
  accept: "field_accept",
  to: "field_to",
  rows: "field_rows",
  expires: "field_expires",
  closure: "field_closure",
  walk: "field_walk",
  partial: "field_partial",
  url: "field_url",
  events: "field_events",
  after: "field_after",
  webhook: "field_webhook",
  active: "field_active",
  overlap: "field_overlap",
} as const;

type Field = keyof typeof FIELDS;
const isField = (name: string): name is Field => Object.hasOwn(FIELDS, name);
const START = /(^|, )([a-z_]+) /g;

/** Fields and their values in order; null: it is no such list. What is not so (False) is left out. */
export function fieldsOf(detail: string): [Field, string][] | null {
  const starts = [...detail.matchAll(START)].filter(([, , name]) => isField(name ?? ""));
  if (starts[0]?.index !== 0) return null;
  return starts.flatMap((start, i) => {
    const value = detail.slice(start.index + start[0].length, starts[i + 1]?.index ?? detail.length);
    return value === "False" ? [] : [[start[2] as Field, plain(value)] as [Field, string]];
  });
}

/** A value as people read it: of several switches those that are on, of a list its members. */
function plain(value: string): string {
  const switches = /^\w+\((.*)\)$/.exec(value);
  if (switches) return [...(switches[1] ?? "").matchAll(/(\w+)=True/g)].map(([, name]) => name).join(", ") || "–";
  const list = /^\((.*?),?\)$/.exec(value);
  return list ? (list[1] ?? "").replaceAll("'", "") : value;
}
