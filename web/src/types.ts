/** What the server sends: the views of the read model as JSON. Times are ISO 8601 UTC. */

export interface Bit {
  name: string;
  value: number;
  meaning: string;
}

export interface Link {
  up: boolean;
  since: string;
  reason: string;
  frames_in: number;
  frames_out: number;
  garbled: number;
  resends: number;
  duplicates: number;
  round_trip_ms: number | null;
}

export interface Hold {
  reason: string;
  remedy: string;
  since: string;
}

export interface Lockout {
  owner: string;
  reason: string;
  since: string;
  releases: string[];
}

export interface Vehicle {
  id: string;
  dev_id: number;
  dialect: string;
  address: string;
  state: string;
  activity: string;
  service: string;
  link: Link;
  mode: string | null;
  oper: string | null;
  code: number | null;
  code_name: string;
  loaded: boolean | null;
  carrier: string | null;
  barcode: string | null;
  dist: number | null;
  seq: number | null;
  status1: string | null;
  status2: string | null;
  bits: Bit[];
  job: string | null;
  goal: string | null;
  waiting: string;
  granted: string[];
  covered: string[];
  hold: Hold | null;
  lockout: Lockout | null;
  seen: string | null;
}

export interface Job {
  id: string;
  order: number;
  state: string;
  leg: string;
  source: string;
  destination: string;
  priority: number;
  carrier: string | null;
  vehicle: string | null;
  wish: string | null;
  fallbacks: string[];
  reason: string;
  result: string;
  actor: string;
  created: string;
  assigned: string | null;
  picked: string | null;
  ended: string | null;
}

export interface Station {
  id: string;
  kind: string;
  barcode: string;
  present: boolean | null;
  carrier: string | null;
  reserved: string;
  out_of_service: string;
  provenance: string;
  verified: boolean;
  at: string | null;
  target: [number, number, number] | null;
  target_version: number | null;
}

export interface Carrier {
  id: string;
  place: string | null;
  provenance: string;
  verified: boolean;
  at: string;
}

export interface Controller {
  plant: string;
  state: string;
  reason: string;
  epoch: number;
  started: string;
  waiting_for: string[];
  trouble: string;
}

export interface Happening {
  seq: number;
  ts: string;
  event: string;
  ceid: number;
  job: string | null;
  carrier: string | null;
  vehicle: string | null;
  source: string | null;
  destination: string | null;
  result: string;
  detail: string;
}

export interface Objects {
  controller: Controller;
  vehicles: Vehicle;
  jobs: Job;
  stations: Station;
  carriers: Carrier;
}

export type Topic = keyof Objects;

export interface LayoutPoint {
  barcode: string;
  x: number;
  y: number;
  park: boolean;
}

export interface LayoutEdge {
  start: string;
  end: string;
  length: number;
  speed: number;
  sensor: number;
  curve: boolean;
}

/** Lengths and places in mm, speeds of edges in percent, of vehicles in mm/s. */
export interface Layout {
  name: string;
  points: LayoutPoint[];
  edges: LayoutEdge[];
  stations: { id: string; kind: string; barcode: string; display: string }[];
  zones: { id: string; name: string; barcodes: string[]; capacity: number; no_stop: boolean }[];
  vehicles: { id: string; length: number; max_speed: number; curve_speed: number }[];
}

export interface FrameRow {
  name: string;
  value: string;
  meaning: string;
  depth: number;
}

export interface Traffic {
  at: string;
  direction: "in" | "out";
  hex: string;
  frames: { kind: string; fields: FrameRow[] }[];
}
