/** What to look for in the past: the stretch of time that is drawn, the events of note in it, and the next one. */
import { signal } from "@preact/signals";
import * as api from "../api";
import { selected } from "../store";
import type { Happening } from "../types";
import { error, kept, moment, pause, seek } from "./player";

export const STRETCHES = { minutes: 600, hour: 3600, shift: 8 * 3600, day: 86_400, all: Number.POSITIVE_INFINITY } as const;
export type Stretch = keyof typeof STRETCHES;

export const stretch = signal<Stretch>("hour");
/** What the scrubber reaches over, UTC seconds. */
export const reach = signal({ from: 0, to: 1 });
export const marks = signal<Happening[]>([]);
/** The event that was stepped to last. */
export const stepped = signal<Happening | null>(null);

/** Shown so long after an event, s: what it changed is published once it is durable. */
const AFTER = 0.5;
const MOST = 1000;

export const iso = (seconds: number): string => new Date(seconds * 1000).toISOString();

let asked = "";

/** Read the events of note in what the scrubber reaches over. */
export async function readMarks(): Promise<void> {
  const { from, to } = reach.value;
  const query = new URLSearchParams({ from: iso(from), to: iso(to + 1), of_note: "true", newest: "true", limit: String(MOST) });
  asked = String(query);
  try {
    const { items } = await api.get<{ items: Happening[] }>(`/history/events?${query}`);
    if (asked === String(query)) marks.value = items;
  } catch (failure) {
    error.value = failure;
  }
}

/** From where to step: the event that is shown, or the moment if nobody stepped there. */
function origin(): number {
  const event = stepped.value;
  const at = event ? Date.parse(event.ts) / 1000 : Number.NaN;
  return Math.abs(at + AFTER - moment.value) < 0.01 ? at : moment.value;
}

/** Go to the next (1) or the one before (-1): of what is chosen, any event; else those of note. */
export async function step(way: 1 | -1): Promise<void> {
  const span = kept.value;
  if (!span) return;
  pause();
  const at = origin();
  const [from, to] = way > 0 ? [at + 0.001, span.to + 1] : [span.from, at];
  if (from >= to) return;
  const pick = selected.value;
  const query = new URLSearchParams({ from: iso(from), to: iso(to), limit: "1", newest: String(way < 0) });
  if (pick?.kind === "vehicle" || pick?.kind === "job") query.set(pick.kind, pick.id);
  else query.set("of_note", "true");
  try {
    const { items } = await api.get<{ items: Happening[] }>(`/history/events?${query}`);
    stepped.value = items[0] ?? null;
    if (items[0]) await goTo(items[0]);
  } catch (failure) {
    error.value = failure;
  }
}

export async function goTo(event: Happening): Promise<void> {
  pause();
  stepped.value = event;
  await seek(Date.parse(event.ts) / 1000 + AFTER);
}
