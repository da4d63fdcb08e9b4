/** Plays back what was recorded: which moment is shown, how fast it goes on, and that the pieces ahead are there in time. */
import { effect, signal } from "@preact/signals";
import * as api from "../api";
import { momentAsked, momentShown, room } from "../route";
import { backToNow, inPast, lookBack, recording, showChange, shown, showWhole } from "../store";
import { t } from "../texts";
import { headOf, piecesOf, Reel, type Screen } from "./reel";
import { Trails } from "./trails";

export const PACES = [1, 2, 4, 8, 16] as const;

export interface Kept {
  /** UTC seconds. */
  from: number;
  to: number;
  incident: { by: string; made: string } | null;
}

/** The moment that is shown, UTC seconds; 0: none yet. */
export const moment = signal(0);
/** The same as lists and fields tell it: they follow only some times a second, since the map wants the time. */
export const told = signal(0);
export const playing = signal(false);
export const pace = signal<number>(1);
/** From when to when something was recorded; null: that is not known yet, or nothing was. */
export const kept = signal<Kept | null>(null);
/** The recording of the moment is being fetched. */
export const loading = signal(false);
/** It is known from when to when something was recorded, or that nothing was. */
export const looked = signal(false);
export const error = signal<unknown>(null);
export const trails = new Trails();

/** Pieces are fetched so far ahead: seconds of the viewer's time. */
const AHEAD = 12;
/** So much is fetched at once, seconds of the viewer's time. */
const PORTION = 10;
/** A moment that was asked for is fetched with so many seconds after it: the rest follows once it is shown. */
const FIRST = 2;
/** What was fetched is gone on with rather than begun anew for so many seconds beyond it. */
const BEYOND = 30;
/** What the lists and panels show follows so often, ms. */
const SHOWN = 100;
/** How often lists and fields follow while it plays, ms. */
const TOLD = 250;
/** Nobody looks at a page that was not painted for longer, ms. */
const LONGEST = 250;
/** Whether more was recorded is asked so often, ms. */
const AGAIN = 5000;
/** Who opens the room without naming a moment sees what was so long ago, s. */
const AT_FIRST = 60;

const reel = new Reel();
const screen: Screen = { whole: showWhole, change: showChange };
let round = 0;
let fetching = false;
let wanted: number | null = null;
let frame = 0;
let last = 0;
let flushed = 0;
let toldAt = 0;
let timer = 0;

const iso = (seconds: number): string => new Date(seconds * 1000).toISOString();

/** Ask from when to when there is something. */
async function look(): Promise<void> {
  try {
    const span = await api.get<{ from: string | null; to: string | null; incident: Kept["incident"] }>("/history/span");
    const found = span.from && span.to ? { from: Date.parse(span.from) / 1000, to: Date.parse(span.to) / 1000, incident: span.incident } : null;
    if (JSON.stringify(found) !== JSON.stringify(kept.value)) kept.value = found;
    looked.value = true;
    error.value = null;
  } catch (failure) {
    error.value = failure;
  }
}

/** Fetch pieces from a moment on, or those after the last one. */
async function fetchOn(from: number, to: number, mine: number): Promise<void> {
  const query = new URLSearchParams({ from: iso(from), to: iso(Math.max(to, from + 0.001)) });
  if (reel.last !== null) query.set("after", String(reel.last));
  const body = await api.bytes(`/history/pieces?${query}`);
  if (mine !== round) return;
  for await (const piece of piecesOf(body)) {
    if (mine !== round) return;
    if (piece.state) trails.whole(piece.begin, piece.state);
    for (const change of piece.changes ?? []) trails.change(change);
    reel.add(piece);
  }
  if (!headOf(body).head.more) reel.until = Math.max(reel.until, to);
  trails.trim(reel.trim());
}

/** Fetch what will be shown soon, if it is not here. */
async function feed(): Promise<void> {
  const span = kept.value;
  if (fetching || !span || wanted !== null || reel.last === null) return;
  const need = Math.min(moment.value + AHEAD * pace.value, span.to);
  if (reel.until >= need) return;
  fetching = true;
  try {
    await fetchOn(reel.until, Math.min(Math.max(need, reel.until + PORTION * pace.value), span.to), round);
    error.value = null;
  } catch (failure) {
    error.value = failure;
    pause();
  } finally {
    fetching = false;
  }
}

/** Show a moment. While it is being fetched another may be asked for: then that one is shown next. */
export async function seek(at: number): Promise<void> {
  const span = kept.value;
  if (!span) return;
  const goal = Math.min(Math.max(at, span.from), span.to);
  moment.value = goal;
  if (reel.holds(goal) && wanted === null) {
    reel.seek(goal, screen);
    shown();
    settle();
    void feed();
    return;
  }
  const busy = wanted !== null;
  wanted = goal;
  if (!busy) await load();
}

async function load(): Promise<void> {
  loading.value = true;
  try {
    for (let at = wanted; at !== null; at = wanted === at ? null : wanted) {
      const mine = ++round;
      if (at < reel.begin || at > reel.until + BEYOND) {
        reel.clear();
        trails.clear();
      }
      const end = Math.min(at + FIRST, kept.value?.to ?? at);
      // The newest state before may lie a minute back, with more between than one answer gives.
      for (let first = true; first || (reel.last !== null && reel.until < at); first = false) await fetchOn(at, end, mine);
      if (mine !== round) return;
      if (reel.begin > at) moment.value = Math.min(reel.begin, kept.value?.to ?? reel.begin);
      reel.seek(moment.value, screen);
      shown();
    }
    error.value = null;
  } catch (failure) {
    error.value = failure;
    playing.value = false;
  } finally {
    wanted = null;
    loading.value = false;
    settle();
  }
  void feed();
}

/** Where it stands still, the address names the moment. */
function settle(): void {
  if (!playing.value && room.value === "playback" && moment.value > 0) momentShown.value = iso(moment.value);
}

export function pause(): void {
  playing.value = false;
  cancelAnimationFrame(frame);
  if (reel.last !== null) {
    reel.forward(moment.value, screen);
    shown();
  }
  settle();
}

export function play(): void {
  const span = kept.value;
  if (!span || playing.value) return;
  if (moment.value >= span.to) void seek(span.from);
  playing.value = true;
  last = performance.now();
  frame = requestAnimationFrame(turn);
}

function turn(now: number): void {
  if (!playing.value) return;
  frame = requestAnimationFrame(turn);
  const took = Math.min(now - last, LONGEST) / 1000;
  last = now;
  void feed();
  if (loading.value || reel.last === null) return;
  const end = kept.value?.to ?? 0;
  const next = moment.value + took * pace.value;
  moment.value = Math.min(next, reel.until, end);
  if (now - flushed >= SHOWN) {
    flushed = now;
    reel.forward(moment.value, screen);
    shown();
  }
  if (moment.value >= end) pause();
}

async function enter(): Promise<void> {
  lookBack();
  const mine = ++round;
  await look();
  if (mine !== round || room.value !== "playback") return;
  window.clearInterval(timer);
  if (!kept.value?.incident) timer = window.setInterval(() => void lookAgain(), AGAIN);
  await show();
}

/** Whether more was recorded; who found nothing at first is shown what there is now. */
async function lookAgain(): Promise<void> {
  await look();
  if (moment.value === 0 && wanted === null && room.value === "playback") await show();
}

/** Show the moment that was asked for, or one shortly ago. */
async function show(): Promise<void> {
  if (!kept.value) return;
  const asked = momentAsked.value === null ? Number.NaN : Date.parse(momentAsked.value) / 1000;
  const first = kept.value.incident ? kept.value.from : kept.value.to - AT_FIRST;
  await seek(Number.isNaN(asked) ? first : asked);
}

function leave(): void {
  round++;
  window.clearInterval(timer);
  cancelAnimationFrame(frame);
  playing.value = false;
  wanted = null;
  moment.value = 0;
  looked.value = false;
  momentShown.value = momentAsked.value = null;
  reel.clear();
  trails.clear();
  backToNow();
}

/** Follow the room: whoever opens playback sees the past, whoever leaves it the present. A recorded incident has nothing else. */
export function begin(): void {
  api.forbidWhile(() => (inPast.value ? t("past_no_commands") : ""));
  effect(() => {
    const at = moment.value;
    const now = performance.now();
    if (playing.value && now - toldAt < TOLD) return;
    toldAt = now;
    told.value = at;
  });
  let inside = false;
  effect(() => {
    const now = room.value === "playback";
    if (now === inside) return;
    inside = now;
    queueMicrotask(() => (now ? void enter() : leave()));
  });
  effect(() => {
    if (recording.value) room.value = "playback";
  });
  momentAsked.subscribe((asked) => {
    if (asked !== null && inside && kept.value && asked !== momentShown.peek()) void seek(Date.parse(asked) / 1000);
  });
}
