/** What the page knows, and how it comes to know it. Objects live in plain maps; a signal per topic says that they changed. */
import { computed, signal } from "@preact/signals";
import * as api from "./api";
import { type LinkState, type Sink, Stream, Watcher } from "./live";
import { Track } from "./track";
import type { Carrier, Controller, Happening, Job, Layout, Objects, Station, Topic, Vehicle } from "./types";

const EVENTS_SHOWN = 200;
const ENDED_SHOWN = 100;
const TOPICS = "controller,vehicles,jobs,stations,carriers,events";
export const ENDED = new Set(["completed", "failed", "cancelled", "aborted"]);

export type Selection = { kind: "vehicle" | "station"; id: string } | null;

export const layout = signal<Layout | null>(null);
export const track = computed(() => (layout.value ? new Track(layout.value) : null));
export const link = signal<LinkState>("connecting");
export const heardAt = signal(0);
export const keyWanted = signal(false);
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
const controllers = new Map<string, Controller>();
const ended = new Map<string, Job>();
const maps: { [T in Topic]: Map<string, Objects[T]> } = { controller: controllers, vehicles, jobs, stations, carriers };

export const changes = {
  controller: signal(0),
  vehicles: signal(0),
  jobs: signal(0),
  stations: signal(0),
  carriers: signal(0),
};
const touched = new Set<Topic>();

export const controller = computed(() => {
  void changes.controller.value;
  return controllers.values().next().value ?? null;
});

export const vehicleList = computed(() => {
  void changes.vehicles.value;
  return [...vehicles.values()].sort((a, b) => a.id.localeCompare(b.id, undefined, { numeric: true }));
});

/** Open and ended jobs, newest first. */
export const jobList = computed(() => {
  void changes.jobs.value;
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

function isTopic(name: string): name is Topic {
  return name in maps;
}

function flush(): void {
  heardAt.value = Date.now();
  for (const topic of touched) changes[topic].value++;
  touched.clear();
}

const sink: Sink = {
  snapshot(objects, lastEvent) {
    for (const topic of Object.keys(maps) as Topic[]) {
      const map = maps[topic] as Map<string, unknown>;
      map.clear();
      for (const [key, value] of Object.entries(objects[topic] ?? {})) map.set(key, value);
      touched.add(topic);
    }
    flush();
    void refreshEnded();
    if (happenings.value.length === 0) void earlier(lastEvent);
  },
  change(topic, key, value) {
    if (!isTopic(topic)) return;
    const map = maps[topic] as Map<string, unknown>;
    if (value !== null) map.set(key, value);
    else {
      map.delete(key);
      if (topic === "jobs") refreshSoon();
    }
    touched.add(topic);
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
  if (api.hasKey()) {
    try {
      query.set("ticket", (await api.post<{ ticket: string }>("/live/ticket")).ticket);
    } catch (error) {
      if (error instanceof api.Refused && error.status === 401) return null;
      throw error;
    }
  }
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  return `${scheme}://${location.host}/api/v1/live?${query}`;
}

/** Read the layout, then watch; waits for a key if the server wants one, and for the server if it is not there. */
export async function start(): Promise<void> {
  try {
    layout.value = await api.get<Layout>("/layout");
  } catch (error) {
    link.value = "lost";
    if (!(error instanceof api.Refused && error.status === 401)) window.setTimeout(() => void start(), 2000);
    return;
  }
  watcher ??= new Watcher(stream, { address, alive: api.alive, state: (now) => (link.value = now) });
  void watcher.open();
}

export function begin(): void {
  api.onKeyWanted(() => (keyWanted.value = true));
  window.setInterval(() => tick.value++, 1000);
  void start();
}
