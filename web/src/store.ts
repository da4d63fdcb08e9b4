/** What the page knows, and how it comes to know it. Objects live in plain maps; a signal per topic says that they changed. */
import { batch, computed, signal } from "@preact/signals";
import * as access from "./access";
import { wrongs } from "./alarms";
import * as api from "./api";
import { joins } from "./ends";
import { type LinkState, type Sink, Stream, Watcher } from "./live";
import type { Change } from "./past/reel";
import { changedOf, ofThen } from "./past/then";
import { type DeviceLook, lookOfDevice } from "./shows";
import { NATURAL } from "./natural";
import { Track } from "./track";
import type { Alarm, Carrier, Closure, Controller, Device, Drive, Happening, Job, Layout, Objects, Station, Topic, Vehicle, Walk } from "./types";

const EVENTS_SHOWN = 200;
const ENDED_SHOWN = 100;
const TOPICS = "controller,vehicles,jobs,stations,carriers,devices,drives,closures,teaching,alarms,walks,events";
export { NATURAL };
export const ENDED = new Set(["completed", "failed", "cancelled", "aborted"]);

/** A device is a door, a buffer or a charger. */
export type Selection = { kind: "vehicle" | "station" | "device" | "drive" | "job"; id: string } | null;

export const layout = signal<Layout | null>(null);
export const track = computed(() => (layout.value ? new Track(layout.value) : null));
export const link = signal<LinkState>("connecting");
/** When the controller was heard last, ms; 0: it has told nothing yet. */
export const heardAt = signal(0);
/** Rises with each connection: what was asked for in vain is read again. */
export const connections = signal(0);
export const selected = signal<Selection>(null);
export const notice = signal("");
/** Rises once a second, for whatever shows an age. */
export const tick = signal(0);
export const happenings = signal<Happening[]>([]);
/** Source and destination of the order being written: the map and the panels fill them too. */
export const order = { source: signal(""), destination: signal(""), carrier: signal("") };

export const vehicles = new Map<string, Vehicle>();
export const jobs = new Map<string, Job>();
export const stations = new Map<string, Station>();
export const carriers = new Map<string, Carrier>();
export const devices = new Map<string, Device>();
export const drives = new Map<string, Drive>();
export const closures = new Map<string, Closure>();
const alarms = new Map<string, Alarm>();
/** Proposals and sessions of teaching; their details are asked for. */
const teaching = new Map<string, { id: number; state: string }>();
const walks = new Map<string, Walk>();
const controllers = new Map<string, Controller>();
const ended = new Map<string, Job>();
type Books = { [T in Topic]: Map<string, Objects[T]> };
const maps: Books = {
  controller: controllers,
  vehicles,
  jobs,
  stations,
  carriers,
  devices,
  drives,
  closures,
  teaching,
  alarms,
  walks,
};

export const changes = {
  controller: signal(0),
  vehicles: signal(0),
  jobs: signal(0),
  stations: signal(0),
  carriers: signal(0),
  devices: signal(0),
  drives: signal(0),
  closures: signal(0),
  teaching: signal(0),
  alarms: signal(0),
  walks: signal(0),
};
const touched = new Set<Topic>();

export const controller = computed(() => {
  void changes.controller.value;
  return controllers.values().next().value ?? null;
});

/** Rises when a vehicle comes or goes: they are sorted then only. */
const members = signal(0);
const vehicleOrder = computed(() => {
  void members.value;
  return [...vehicles.keys()].sort((a, b) => NATURAL.compare(a, b));
});

export const vehicleList = computed(() => {
  void changes.vehicles.value;
  return vehicleOrder.value.flatMap((id) => vehicles.get(id) ?? []);
});

export type MachineKind = "door" | "buffer" | "charger";

/** Doors, buffers and chargers in the order of the plant file. */
export const machines = computed<{ id: string; kind: MachineKind }[]>(() => {
  const { doors = [], buffers = [], chargers: places = [] } = layout.value ?? {};
  const of = (list: { id: string }[], kind: MachineKind) => list.map(({ id }) => ({ id, kind }));
  return [...of(doors, "door"), ...of(buffers, "buffer"), ...of(places, "charger")];
});

/** What is wrong now, whatever moment is shown. */
export const troubles = computed(() => {
  void changes.vehicles.value;
  void changes.devices.value;
  void changes.drives.value;
  void aside.value;
  const now = inPast.value ? live : maps;
  const [first = null] = now.controller.values();
  void controller.value;
  return wrongs({ controller: first, vehicles: now.vehicles.values(), devices: now.devices.values(), drives: now.drives.values() });
});

export const driveList = computed(() => {
  void changes.drives.value;
  return [...drives.values()].sort(byId);
});

export function byId(a: { id: string }, b: { id: string }): number {
  return NATURAL.compare(a.id, b.id);
}

export const closureList = computed(() => {
  void changes.closures.value;
  return [...closures.values()].sort((a, b) => b.id - a.id);
});

/** The alarms that the controller keeps now, whatever moment is shown, newest first. */
export const alarmList = computed(() => {
  void changes.alarms.value;
  void aside.value;
  const now = (inPast.value ? live : maps).alarms;
  return [...now.values()].filter((alarm) => alarm.ended === null).sort((a, b) => b.id - a.id);
});

/** What the page itself sees to be wrong and the controller keeps no alarm for: its own trouble, lockouts, holds that were asked for. */
export const alongside = computed(() => {
  const told = new Set(alarmList.value.flatMap(({ source, cause }) => [source, cause]));
  return troubles.value.filter(({ source, cause }) => !told.has(source) && !told.has(cause));
});

/** How many alarms there are: the one count of them, in the rooms' bar, as the room's title and over the past. */
export const alarmCount = computed(() => alarmList.value.length + alongside.value.filter(({ grave }) => grave).length);
export const unacknowledged = computed(() => alarmList.value.filter(({ acknowledged }) => !acknowledged).length);

export const stationList = computed(() => {
  void changes.stations.value;
  return [...stations.values()].sort(byId);
});

export const carrierList = computed(() => {
  void changes.carriers.value;
  return [...carriers.values()].sort(byId);
});

/** Open and ended jobs, newest first; of the past the open ones. */
export const jobList = computed(() => {
  void changes.jobs.value;
  if (inPast.value) return [...jobs.values()].sort((a, b) => b.order - a.order);
  return [...jobs.values(), ...[...ended.values()].filter((job) => !jobs.has(job.id))].sort((a, b) => b.order - a.order);
});

export function vehicleNow(id: string): Vehicle | undefined {
  void changes.vehicles.value;
  return vehicles.get(id);
}

export function stationNow(id: string): Station | undefined {
  void changes.stations.value;
  return stations.get(id);
}

export function deviceNow(id: string): Device | undefined {
  void changes.devices.value;
  return devices.get(id);
}

/** Choose a door, buffer or charger; a buffer is shown with the station that it belongs to. */
export function chooseDevice(id: string): void {
  const station = layout.value?.stations.find((one) => one.buffer === id);
  selected.value = station ? { kind: "station", id: station.id } : { kind: "device", id };
}

export function driveNow(id: string): Drive | undefined {
  void changes.drives.value;
  return drives.get(id);
}

/** AGVs that charge at a charger: those on their way there are named by the server, too. */
function chargingAt(id: string): string[] {
  const tag = layout.value?.chargers.find((charger) => charger.id === id)?.barcode;
  return [...vehicles.values()].filter((one) => one.activity === "charging" && one.barcode === tag).map((one) => one.id);
}

/** How a door, buffer or charger looks. */
export function lookAt(id: string): DeviceLook {
  const device = devices.get(id);
  if (!layout.value?.chargers.some((charger) => charger.id === id)) return lookOfDevice(device);
  const taken = chargingAt(id).length > 0;
  return device ? lookOfDevice(device, taken) : taken ? "charging" : "free";
}

/** Who is in a door or will pass it, or charges at a charger. */
export function passers(id: string): string[] {
  return [...new Set([...(devices.get(id)?.vehicles ?? []), ...chargingAt(id)])];
}

/** Who is at which machine, as one text: it changes far less often than the vehicles do. */
export const presence = computed(() => {
  void changes.devices.value;
  void changes.vehicles.value;
  return machines.value.map(({ id }) => `${id} ${passers(id).join()}`).join();
});

/** Choose an end of the order; an end at the other side that no vehicle could join to it is forgotten. */
export function orderFrom(id: string): void {
  order.source.value = id;
  if (!joins(layout.value, id, order.destination.value)) order.destination.value = "";
}

export function orderTo(id: string): void {
  order.destination.value = id;
  if (!joins(layout.value, order.source.value, id)) order.source.value = "";
}

function isTopic(name: string): name is Topic {
  return name in maps;
}

/** Whether the past is shown: then the maps have what was, and the stream goes on in books kept aside. */
export const inPast = signal(false);
/** Whether a moment of the past is shown already. */
export const pastShown = signal(false);
/** The server replays a recorded incident: there is no present. */
export const recording = signal(false);
let live: Books = maps;
/** Rises when the books kept aside change. */
const aside = signal(0);

/** Show something other than the present. */
export function lookBack(): void {
  if (inPast.value) return;
  live = Object.fromEntries(Object.entries(maps).map(([topic, map]) => [topic, new Map<string, unknown>(map)])) as unknown as Books;
  inPast.value = true;
  pastShown.value = false;
  fill({});
  members.value++;
  shown();
}

/** Show the present again. */
export function backToNow(): void {
  if (!inPast.value) return;
  fill(Object.fromEntries(Object.entries(live).map(([topic, map]) => [topic, Object.fromEntries(map as Map<string, unknown>)])));
  live = maps;
  inPast.value = false;
  members.value++;
  shown();
  void refreshEnded();
}

/** Show these objects of the past and no others. */
export function showWhole(objects: Record<string, Record<string, Record<string, unknown>>>): void {
  const whole = { ...objects, vehicles: Object.fromEntries(Object.entries(objects["vehicles"] ?? {}).map(([id, now]) => [id, ofThen(id, now)])) };
  fill(whole);
  members.value++;
  pastShown.value = true;
}

/** Show a change of the past; of a vehicle there is only what is other than before. */
export function showChange([, topic, key, value]: Change): void {
  if (!isTopic(topic)) return;
  const map = maps[topic] as Map<string, unknown>;
  put(map, topic, key, topic === "vehicles" && value !== null ? vehicleThen(key, value) : value);
}

function vehicleThen(id: string, value: Record<string, unknown>): Vehicle {
  const before = vehicles.get(id);
  return before ? changedOf(before, value) : ofThen(id, value);
}

function put(map: Map<string, unknown>, topic: Topic, key: string, value: unknown): void {
  if (topic === "vehicles" && map === vehicles && (value === null || !map.has(key))) members.value++;
  if (value === null) map.delete(key);
  else map.set(key, value);
  touched.add(topic);
}

function fill(objects: Record<string, Record<string, unknown>>, books: Books = maps): void {
  for (const topic of Object.keys(books) as Topic[]) {
    const map = books[topic] as Map<string, unknown>;
    map.clear();
    for (const [key, value] of Object.entries(objects[topic] ?? {})) map.set(key, value);
    touched.add(topic);
  }
}

/** One round for all that changed: what shows several topics is drawn once. */
export function shown(): void {
  batch(() => {
    for (const topic of touched) changes[topic].value++;
    touched.clear();
  });
}

function flush(): void {
  batch(() => {
    heardAt.value = Date.now();
    if (inPast.value) aside.value++;
    else shown();
  });
}

const sink: Sink = {
  snapshot(objects, lastEvent) {
    const [now] = Object.values(objects["controller"] ?? {}) as Controller[];
    recording.value = now?.recording ?? false;
    fill(objects, live);
    if (!inPast.value) members.value++;
    connections.value++;
    flush();
    void refreshEnded();
    if (happenings.value.length === 0) void earlier(lastEvent);
  },
  change(topic, key, value) {
    if (!isTopic(topic)) return;
    if (inPast.value) {
      const map = live[topic] as Map<string, unknown>;
      if (value === null) map.delete(key);
      else map.set(key, value);
      return;
    }
    put(maps[topic] as Map<string, unknown>, topic, key, value);
    if (value === null && topic === "jobs") refreshSoon();
  },
  changed: flush,
  events: remember,
  forget() {
    happenings.value = [];
  },
  problem(text) {
    notice.value = text;
  },
};

function remember(events: Happening[]): void {
  const known = new Set(happenings.value.map((event) => event.seq));
  const all = [...happenings.value, ...events.filter((event) => !known.has(event.seq))];
  happenings.value = all.sort((a, b) => b.seq - a.seq).slice(0, EVENTS_SHOWN);
}

async function earlier(last: number): Promise<void> {
  if (last < 1) return;
  try {
    remember((await api.get<{ items: Happening[] }>(`/events?after=${Math.max(0, last - 60)}&limit=60`)).items);
  } catch {
    /* The ticker starts empty then; the stream brings what follows. */
  }
}

let refreshing = 0;

/** Jobs leave the live model when they end: the list asks for how they ended. */
function refreshSoon(): void {
  window.clearTimeout(refreshing);
  refreshing = window.setTimeout(() => void refreshEnded(), 250);
}

async function refreshEnded(): Promise<void> {
  try {
    const { items } = await api.get<{ items: Job[] }>(`/jobs?limit=${ENDED_SHOWN}`);
    ended.clear();
    for (const job of items) if (ENDED.has(job.state)) ended.set(job.id, job);
    changes.jobs.value++;
  } catch {
    /* The next job that ends asks again. */
  }
}

const stream = new Stream(sink);
let watcher: Watcher | null = null;

async function address(after: number | null): Promise<string | null> {
  const query = new URLSearchParams({ topics: TOPICS });
  if (after !== null) query.set("after", String(after));
  // Asked for where nobody has to log in, too: that may have changed, and a socket cannot say why it was refused.
  try {
    query.set("ticket", (await api.post<{ ticket: string }>("/live/ticket")).ticket);
  } catch (error) {
    if (error instanceof api.Refused && error.status === 401) return null;
    throw error;
  }
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  return `${scheme}://${location.host}/api/v1/live?${query}`;
}

/** What a quiet plant told last still holds while the server answers. */
async function alive(): Promise<boolean> {
  const there = await api.alive();
  if (there && link.value === "live") heardAt.value = Date.now();
  return there;
}

/** Read the layout, then watch; waits for a log-in if the server wants one, and for the server if it is not there. */
async function start(): Promise<void> {
  try {
    layout.value = await api.get<Layout>("/layout");
  } catch (error) {
    link.value = "lost";
    if (!(error instanceof api.Refused && error.status === 401)) window.setTimeout(() => void start(), 2000);
    return;
  }
  watcher ??= new Watcher(stream, { address, alive, state: (now) => (link.value = now) });
  void watcher.open();
}

export function begin(): void {
  access.begin(
    () => void (watcher ? watcher.open() : start()),
    () => (link.value = "lost"),
  );
  window.setInterval(() => tick.value++, 1000);
  void start();
}
