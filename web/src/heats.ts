/** The heat of a period, as the server has counted it; null: what this page has seen itself is all there is. */
import { computed, effect, signal } from "@preact/signals";
import { get } from "./api";
import { Heat, type HeatCounts } from "./heat";
import { heatHours, heatShown } from "./layers";
import { told } from "./past/player";
import { inPast } from "./store";

/** The server counts so many seconds together. */
const TOGETHER = 300;
/** So often it is asked again, s: it keeps what it counts as often. */
const EVERY = 60;
const HOUR = 3600;

export const heatKept = signal<Heat | null>(null);

/** Hours, and where they end (UTC s; 0: now); null: nothing is asked for. */
const wanted = computed(() => {
  if (heatShown.value === null || heatHours.value === 0) return null;
  const end = inPast.value ? Math.ceil(told.value / TOGETHER) * TOGETHER : 0;
  return `${heatHours.value} ${end}`;
});

/** Ask for the heat that is wanted, again and again while it is that of the present. Returns how to end it. */
export function begin(): () => void {
  let timer = 0;
  let last = 0;
  const ask = async (hours: number, end: number): Promise<void> => {
    const mine = ++last;
    const to = end || Date.now() / 1000;
    const query = new URLSearchParams({ from: iso(to - hours * HOUR), ...(end ? { to: iso(end) } : {}) });
    const found = await get<HeatCounts & { from: string | null }>(`/history/heat?${query}`).catch(() => null);
    if (mine !== last) return;
    heatKept.value = found?.from ? Heat.of(found) : null;
    if (!end) timer = window.setTimeout(() => void ask(hours, end), EVERY * 1000);
  };
  const stop = effect(() => {
    const now = wanted.value;
    clearTimeout(timer);
    last++;
    if (now === null) heatKept.value = null;
    else void ask(...(now.split(" ").map(Number) as [number, number]));
  });
  return () => {
    clearTimeout(timer);
    last++;
    stop();
  };
}

const iso = (seconds: number): string => new Date(seconds * 1000).toISOString();
