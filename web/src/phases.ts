/** How long each phase of a job took, from its events: the same phases as in the statistics. Pure. */
import type { Happening } from "./types";

export type Phase = "queued" | "fetching" | "acquiring" | "carrying" | "depositing";

/** What ends a phase; the last of them counts, since an assignment may have been another's before; none before it was taken back does. */
const ENDS: [Phase, string][] = [
  ["queued", "VehicleAssigned"],
  ["fetching", "VehicleAcquireStarted"],
  ["acquiring", "VehicleAcquireCompleted"],
  ["carrying", "VehicleDepositStarted"],
  ["depositing", "VehicleDepositCompleted"],
];

/** The last event by which the job lost its vehicle and went on, its index; -1: none. At its end it loses it, too: `over`. */
export function lastTakenBack(events: Happening[], over: boolean): number {
  const assigned = events.findLastIndex(({ event }) => event === "VehicleAssigned");
  return events.findLastIndex(({ event }, i) => event === "VehicleUnassigned" && (!over || i < assigned));
}

/** Phases with their seconds, in order; the one under way lasts until `now` (ms), null: the job is over. */
export function phasesOf(created: string, now: number | null, events: Happening[]): { name: Phase; took: number }[] {
  const found: { name: Phase; took: number }[] = [];
  const since = events.slice(lastTakenBack(events, now === null) + 1);
  let from = Date.parse(created);
  for (const [name, end] of ENDS) {
    const ended = since.findLast(({ event }) => event === end);
    const to = ended ? Date.parse(ended.ts) : now;
    if (to === null || to < from) break;
    found.push({ name, took: (to - from) / 1000 });
    if (!ended) break;
    from = to;
  }
  return found;
}
