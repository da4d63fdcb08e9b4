/**
 * Where to draw a vehicle between two reports. It reports a barcode and the mm beyond it; we drive the drawn one along the
 * track it has been granted, at the pace of its reports, and never beyond the grant. Pure: the caller brings the time.
 */
import type { Spot, Track } from "./track";

export interface Report {
  barcode: string | null;
  dist: number | null;
  granted: string[];
  /** Whether it drives: one that stands is drawn where it says. */
  moving: boolean;
}

/** The drawn one runs on at its last pace for so long when no report comes, s. */
const RUN_ON = 1.2;
/** Reports lag and jump: share of the gap to make good per second. */
const CATCH_UP = 2.5;
/** A gap longer than this is not driven but jumped, mm. */
const JUMP = 12_000;

export class Glide {
  private path: string[] = [];
  private s = 0;
  private reported = 0;
  private pace = 0;
  private since = 0;
  private moving = false;
  private last = 0;

  constructor(
    private readonly track: Track,
    private readonly topSpeed = 3000,
  ) {}

  /** Take a report at `now` (s). */
  report(report: Report, now: number): void {
    const { barcode } = report;
    if (barcode === null || !this.track.points.has(barcode)) {
      this.path = [];
      return;
    }
    const ahead = this.connected(barcode, report.granted);
    const reached = this.reach(barcode, ahead);
    const offset = reached === null ? 0 : this.lengthTo(reached);
    if (reached === null) {
      this.path = ahead;
      this.s = 0;
    }
    const at = offset + Math.max(0, report.dist ?? 0);
    if (reached === null) this.s = Math.min(at, this.lengthTo(this.path.length - 1));
    this.learn(reached === null ? 0 : at - this.reported, now - this.since, report.moving && reached !== null);
    this.reported = at;
    this.since = now;
    this.moving = report.moving;
  }

  /** Drive on to `now` (s) and say where it is; null while its place is not known. `still`: draw reports as they come. */
  spot(now: number, still = false): Spot | null {
    const first = this.path[0];
    if (first === undefined) return null;
    const dt = Math.min(Math.max(now - this.last, 0), 0.25);
    this.last = now;
    const end = this.lengthTo(this.path.length - 1);
    const run = this.moving && !still ? this.pace * Math.min(now - this.since, RUN_ON) : 0;
    const goal = Math.min(this.reported + run, Math.max(end, this.s));
    const gap = goal - this.s;
    if (still || Math.abs(gap) > JUMP) this.s = goal;
    else if (gap > 0) {
      const pace = Math.min(this.topSpeed * 1.3, (this.moving ? this.pace : 0) + gap * CATCH_UP);
      this.s = Math.min(goal, this.s + Math.max(pace, 150) * dt);
    } else if (!this.moving) this.s = Math.max(goal, this.s + Math.min(-150, gap * CATCH_UP) * dt);
    this.trim();
    return this.place();
  }

  /** Whether the drawn place still differs from the reported one. */
  get busy(): boolean {
    return this.moving || Math.abs(this.reported - this.s) > 5;
  }

  private place(): Spot | null {
    let rest = this.s;
    for (let i = 0; i + 1 < this.path.length; i++) {
      const way = this.track.way(this.path[i] as string, this.path[i + 1] as string);
      if (!way) break;
      if (rest <= way.edge.length || i + 2 === this.path.length) return this.track.along(way, rest);
      rest -= way.edge.length;
    }
    return this.track.spot(this.path[0] as string) ?? null;
  }

  /** The report's own path, as far as edges join it; at least one edge on, to have a heading and room for `dist`. */
  private connected(barcode: string, granted: string[]): string[] {
    const path = [barcode];
    for (const step of granted) {
      const here = path[path.length - 1] as string;
      if (step === here) continue;
      if (!this.track.way(here, step)) break;
      path.push(step);
    }
    const only = this.track.next.get(barcode);
    if (path.length === 1 && only?.length === 1) path.push((only[0] as { end: string }).end);
    return path;
  }

  /** Lay the report's path behind the drawn place; returns the index of its barcode, or null if it is elsewhere. */
  private reach(barcode: string, ahead: string[]): number | null {
    if (this.path.length === 0) return null;
    const known = this.path.indexOf(barcode);
    if (known >= 0) {
      this.path = [...this.path.slice(0, known), ...ahead];
      return known;
    }
    const here = this.path[0] as string;
    const way = this.track.path(here, barcode);
    if (!way) return null;
    this.path = [...way.slice(0, -1), ...ahead];
    if (this.lengthTo(way.length - 1) - this.s > JUMP) return null;
    return way.length - 1;
  }

  private learn(travelled: number, took: number, moving: boolean): void {
    if (!moving) this.pace = 0;
    else if (took > 0.02 && travelled >= 0) {
      const measured = Math.min(travelled / took, this.topSpeed);
      this.pace = this.pace === 0 ? measured : this.pace * 0.5 + measured * 0.5;
    }
  }

  private lengthTo(index: number): number {
    let sum = 0;
    for (let i = 0; i < index; i++) {
      sum += this.track.way(this.path[i] as string, this.path[i + 1] as string)?.edge.length ?? 0;
    }
    return sum;
  }

  private trim(): void {
    while (this.path.length > 2) {
      const length = this.track.way(this.path[0] as string, this.path[1] as string)?.edge.length ?? 0;
      if (this.s < length || this.reported < length) return;
      this.path.shift();
      this.s -= length;
      this.reported -= length;
    }
  }
}
