/** Where vehicles wait, and where many come by: counted on this page since it was opened, or by the server. Pure. */
import type { Vehicle } from "./types";

export type HeatKind = "waiting" | "traffic";

/** Seconds waited, and vehicles that came, by barcode. */
export type HeatCounts = Record<HeatKind, Record<string, number>>;

/** A longer gap between two reports is not counted as a wait, s. */
const GAP = 5;

export class Heat {
  /** Seconds waited, and vehicles that came, by barcode. */
  private readonly counts: Record<HeatKind, Map<string, number>> = { waiting: new Map(), traffic: new Map() };
  private readonly last = new Map<string, { barcode: string; at: number; waits: boolean }>();

  /** What the server has counted. */
  static of(given: HeatCounts): Heat {
    const heat = new Heat();
    for (const kind of ["waiting", "traffic"] as const) {
      for (const [barcode, count] of Object.entries(given[kind])) heat.add(kind, barcode, count);
    }
    return heat;
  }

  clear(): void {
    this.last.clear();
    for (const counts of Object.values(this.counts)) counts.clear();
  }

  /** A vehicle's report at `now` (s). */
  take(vehicle: Vehicle, now: number): void {
    const { barcode } = vehicle;
    if (barcode === null) return;
    const before = this.last.get(vehicle.id);
    if (before?.waits) this.add("waiting", before.barcode, Math.min(now - before.at, GAP));
    if (before && before.barcode !== barcode) this.add("traffic", barcode, 1);
    const waits = vehicle.activity === "waiting";
    if (!before) this.last.set(vehicle.id, { barcode, at: now, waits });
    else Object.assign(before, { barcode, at: now, waits });
  }

  /** Each counted barcode with its share of the most (0 to 1), on a scale on which half of it is still seen. */
  shares(kind: HeatKind): [string, number][] {
    const counts = this.counts[kind];
    let most = 0;
    for (const count of counts.values()) most = Math.max(most, count);
    return [...counts].map(([barcode, count]) => [barcode, Math.sqrt(count / most)]);
  }

  most(kind: HeatKind): number {
    let most = 0;
    for (const count of this.counts[kind].values()) most = Math.max(most, count);
    return most;
  }

  private add(kind: HeatKind, barcode: string, count: number): void {
    this.counts[kind].set(barcode, (this.counts[kind].get(barcode) ?? 0) + count);
  }
}
