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

/** What only AGVs report. `toward`: the tag on the way to which it was stopped. */
export interface Agv {
  cart: string;
  lift: string;
  charging: boolean;
  in_position: boolean;
  steering: string;
  path: number;
  tag: string;
  toward: string | null;
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
  /** The vehicle that it waits for. */
  waits_for?: string | null;
  granted: string[];
  covered: string[];
  hold: Hold | null;
  lockout: Lockout | null;
  seen: string | null;
  agv?: Agv | null;
  /** Idle, at a parking place. */
  parked: boolean;
}

/** A door, a buffer or a charger. Its state is its last word, and counts only while it is fresh. */
export interface Device {
  id: string;
  kind: string;
  link: string | null;
  number: number | null;
  fresh: boolean;
  reason: string;
  state: string | null;
  since: string | null;
  seen: string | null;
  out_of_service: string;
  /** The command under way. */
  pending: string;
  /** In the door, granted the way through it, or charging there; `waiting` want it soon. */
  vehicles: string[];
  waiting: string[];
  /** A person keeps the door open or closed. */
  pin: { position: string; owner: string; reason: string; since: string } | null;
  /** For whom the buffer is locked; `locked` null: not known whether it is by now. */
  lock: { owner: string; person: boolean; since: string; locked: boolean | null } | null;
  lockout: Lockout | null;
  alarm: string;
  remedy: string;
  contradiction: string;
}

/** An axis drive; `online` is null before it was heard on this connection of its line. */
export interface Drive {
  id: string;
  name: string;
  line: string;
  address: number;
  model: string;
  online: boolean | null;
  reason: string;
  mode: string | null;
  output: number | null;
  code: number | null;
  meaning: string;
  turn: string | null;
  /** Hundredths of the axis's unit. */
  distance: number | null;
  seen: string | null;
  /** What an error means, and what helps. */
  error: string;
  remedy: string;
  moving: boolean | null;
  operation: string | null;
  lockout: Lockout | null;
}

/** Something that was asked about a drive: running, done, failed, or unknown (it may have taken effect). */
export interface Operation {
  id: string;
  kind: string;
  state: string;
  done: number;
  total: number;
  /** What has come of it so far; what there is depends on the kind. */
  result: Record<string, unknown>;
  reason: string;
  remedy: string;
}

/** A parameter of a drive as last known; `number` in hexadecimal, `raw` null if it was not read yet. */
export interface Parameter {
  number: string;
  named: boolean;
  name: string;
  unit: string;
  raw: number | null;
  text: string;
  at: string | null;
  read_only: boolean;
  lowest: number | null;
  highest: number | null;
  value: number | null;
  description: string;
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

/** Why a job went as it did: its assignments with those that were thought of, and its waits. Spans in s. */
export interface JobWhy {
  job: string;
  state: string;
  reason: string;
  created: string;
  queued: number | null;
  fetching: number | null;
  acquiring: number | null;
  carrying: number | null;
  depositing: number | null;
  total: number | null;
  assignments: Assignment[];
  waits: { since: string; until: string | null; seconds: number | null; reason: string }[];
  left_out: number;
}

export interface Assignment {
  at: string;
  vehicle: string;
  seconds: number;
  priority: number;
  hot: boolean;
  waited: number;
  switch: number;
  before: string | null;
  saved: number | null;
  candidates: { vehicle: string; seconds: number | null; why_not: string }[];
}

/** A command and what became of it. */
export interface Command {
  cmd_id: string;
  vehicle: string;
  kind: string;
  state: string;
  actor: string;
  opened: string;
  closed: string | null;
  outcome: string;
  job: string | null;
}

export interface RouteShown {
  barcodes: string[];
  length: number;
  seconds: number;
  free_flow_seconds: number;
  version: number;
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
  /** Axes that the DEST lacks, and the session that closes the port. */
  missing: string[];
  teaching: number | null;
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
  /** Fires and earthquakes that nobody has released yet, in words. */
  emergencies: string[];
  /** Vehicles that wait for each other now, in words; how many such circles were found and are over, since the start. */
  pauses: Pause[];
  circles: string[];
  circles_found: number;
  circles_resolved: number;
  /** What routes keep off, a line for each reason; the places counted; the stations that nobody can reach for that. */
  kept_off: string[];
  closed_places: number;
  cut_off: string[];
  /** How many vehicles under way were led another way: round what is closed, and because it was quicker. */
  led_round: number;
  led_quicker: number;
  /** A recorded incident, replayed. */
  recording?: boolean;
  /** Pieces of track that take twice as long as usual for the traffic on them; how often ways were weighed anew by that. */
  slow_track: number;
  weighed: number;
  /** So many hoists may be on their way with jobs now; null: as many as there are. */
  restrained_to?: number | null;
}

/** An audit walk: open, accepted or abandoned; of so many `places` so many are `entered`. */
export interface Walk {
  id: number;
  actor: string;
  reason: string;
  state: string;
  started: string;
  ended: string | null;
  ended_by: string | null;
  places: number;
  entered: number;
}

/** A place of a walk: what the books say `now`, what was `seen` there (null: not yet), and what that comes to. */
export interface WalkPlace {
  station: string;
  now: boolean | null;
  now_carrier: string | null;
  seen: boolean | null;
  seen_carrier: string | null;
  by: string | null;
  at: string | null;
  finding: string;
}

/** Something that is, or was, wrong; `ended` null: it is there now. */
export interface Alarm {
  id: number;
  kind: string;
  source: string;
  code: string;
  cause: string;
  remedy: string;
  begun: string;
  ended: string | null;
  outcome: string;
  acknowledged: string | null;
  acknowledged_by: string | null;
  note: string;
}

export interface AlarmCount {
  kind: string | null;
  source: string | null;
  code: string | null;
  times: number;
  minutes: number;
  share: number;
}

/** Durations in s. */
export interface TimesShown {
  count: number;
  mean: number | null;
  p50: number | null;
  p95: number | null;
  longest: number | null;
}

/** A completed job that took long: its phases in s, and its longest wait in words. */
export interface LateShown {
  job: string;
  carrier: string | null;
  source: string;
  destination: string;
  vehicle: string | null;
  created: string;
  queued: number | null;
  fetching: number | null;
  acquiring: number | null;
  carrying: number | null;
  depositing: number | null;
  total: number | null;
  waited: number;
  reason: string;
}

export interface StatisticsShown {
  from: string;
  to: string;
  jobs: Record<string, number>;
  phases: Record<string, TimesShown>;
  empty_share: number | null;
  intervals: { begin: string; ordered: number; completed: number; unfinished: number; queue: number; delivery: TimesShown }[];
  vehicles: {
    vehicle: string;
    completed: number;
    busy_share: number;
    failures: number;
    mtbf_hours: number | null;
    mttr_minutes: number | null;
    availability: number;
  }[];
  waits: { cause: string; times: number; seconds: number }[];
  places: { place: string; jobs: number; seconds: number; cause: string }[];
  late: LateShown[];
  open: { job: string; carrier: string | null; source: string; destination: string; priority: number; created: string; seconds: number; reason: string }[];
}

/** A reason for which a place is closed: draining while vehicles are inside, then closed. */
export interface Closure {
  id: number;
  kind: "barcode" | "edge" | "stretch" | "zone" | "station";
  names: string[];
  place: string;
  barcodes: string[];
  stations: string[];
  reason: string;
  owner: string;
  purpose: string;
  state: string;
  since: string;
  expires: string | null;
  releases: string[];
  inside: string[];
  waiting: string[];
}

export interface ClosurePreview {
  place: string;
  barcodes: string[];
  stations: string[];
  cut_off: string[];
  inside: string[];
  shut_in: string[];
  jobs_touched: number;
  jobs: { job: string; why: string }[];
  routes: {
    compared: number;
    longer: number;
    lost: number;
    mean_seconds: number;
    mean_seconds_after: number;
    worst: { from: string; to: string; seconds: number; seconds_after: number }[];
  };
}

export interface Pause {
  zone: string;
  owner: string;
  reason: string;
  since: string;
  stopped: boolean;
}

export interface ZoneNow {
  id: string;
  name: string;
  capacity: number;
  no_stop: boolean;
  state: string;
  pause: Pause | null;
  vehicles: string[];
}

/** Positions of the taught axes in pulses; null where one is not known. */
export interface Axes {
  shft: number | null;
  rota: number | null;
  lift: number | null;
}

export interface PulsesVersion extends Axes {
  version: number;
  actor: string;
  source: string;
  at: string;
  basis: { axis: string; raw: number; vehicle: string; barcode: string; against: string; version: number; less: number | null }[];
  proposal: number | null;
  restores: number | null;
  reason: string;
}

/** What one vehicle is sent at one port, before and after. */
export interface PulseChange {
  station: string;
  vehicle: string;
  old: Axes;
  new: Axes;
  beyond: string;
}

export interface Comparison {
  old: PulsesVersion;
  new: PulsesVersion;
  differences: Axes;
  changes: PulseChange[];
}

export interface Proposal {
  id: number;
  side: "dest" | "offset";
  vehicle: string;
  barcode: string;
  station: string | null;
  session: number | null;
  state: string;
  why: string;
  remedy: string;
  warnings: string[];
  raw: Axes;
  asked_by: string | null;
  at: string;
  result: Axes | null;
  base: number;
  closed: string | null;
  closed_by: string | null;
  reason: string;
  revision: number;
}

export interface ProposalDetail extends Proposal {
  present: PulsesVersion | null;
  changes: PulseChange[];
  drift: string;
}

export interface TeachingSession {
  id: number;
  station: string;
  vehicle: string;
  actor: string;
  state: string;
  opened: string;
}

export interface SessionDetail extends TeachingSession {
  proposals: Proposal[];
  /** What to do next, in one sentence. */
  advice: string;
}

export interface TaughtTarget extends Axes {
  refusal: string;
  reference: boolean;
  dest: PulsesVersion | null;
  offset: PulsesVersion | null;
}

export interface Drifted {
  side: "dest" | "offset";
  name: string;
  drift: string;
  old: PulsesVersion;
  new: PulsesVersion;
}

export interface Backup {
  id: number;
  drive: string;
  at: string;
  actor: string;
  note: string;
  parameters: number;
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
  devices: Device;
  drives: Drive;
  closures: Closure;
  teaching: { id: number; state: string };
  alarms: Alarm;
  walks: Walk;
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

export interface LayoutVehicle {
  id: string;
  kind: string;
  /** The line of an AGV; a hoist has one of its own. */
  link: string | null;
  length: number;
  max_speed: number;
  curve_speed: number;
}

/** A door across the pieces of track between these pairs of barcodes, whichever way they are driven. */
export interface LayoutDoor {
  id: string;
  link: string;
  number: number;
  passages: [string, string][];
  normally_open: boolean;
}

/** `soft`: no hard cap, but a share of its slots that may be filled from outside, while nobody waits `patience` s. */
export interface LayoutZone {
  id: string;
  name: string;
  barcodes: string[];
  capacity: number;
  no_stop: boolean;
  soft: { share: number; patience: number } | null;
}

/** Lengths and places in mm, speeds of edges in percent, of vehicles in mm/s. */
export interface Layout {
  name: string;
  /** Of the plant; null where no versions are kept. */
  version?: number | null;
  points: LayoutPoint[];
  edges: LayoutEdge[];
  stations: { id: string; kind: string; barcode: string; display: string; buffer: string | null }[];
  zones: LayoutZone[];
  vehicles: LayoutVehicle[];
  links: { id: string; protocol: string; address: string }[];
  doors: LayoutDoor[];
  buffers: { id: string; link: string; number: number }[];
  chargers: { id: string; barcode: string; alias: string | null }[];
  drives: { id: string; name: string; line: string; address: number; model: string }[];
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
