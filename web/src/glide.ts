/**
 * Where to draw a vehicle between two reports. It reports a barcode and the mm beyond it; we drive the drawn one along the
 * track it has been granted, at the pace of its reports, and never beyond the grant. Pure: the caller brings the time.
 */
import type { Spot, Track, Way } from "./track";

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
/** Track kept behind the front, so that the hull bends with the rail, mm. */
const TAIL = 1500;

export class Glide {
  private path: string[] = [];
  /** The ways between the barcodes of the path: `ways[i]` leads from `path[i]` on. */
  private ways: (Way | undefined)[] = [];
  private s = 0;
  private reported = 0;
  /** Index in the path of the barcode that was reported last: track driven both ways may have it twice. */
  private here = 0;
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
      this.lay([]);
      return;
    }
    const ahead = this.connected(barcode, report.granted);
    const reached = this.reach(barcode, ahead);
    let offset = this.lengthTo(reached ?? 0);
    this.here = reached ?? 0;
    if (reached === null) {
      const tail = this.tail(barcode);
      this.lay([...tail, ...ahead]);
      this.here = tail.length;
      offset = this.lengthTo(tail.length);
    }
    const at = offset + Math.max(0, report.dist ?? 0);
    if (reached === null) this.s = Math.min(at, this.lengthTo(this.path.length - 1));
    const travelled = reached === null ? 0 : at - this.reported;
    this.moving = report.moving;
    if (!report.moving || reached === null) this.pace = 0;
    else if (travelled < 1) return;
    else this.learn(travelled, now - this.since);
    this.reported = at;
    this.since = now;
  }

  /** Drive on to `now` (s). `still`: jump to where the report says. */
  drive(now: number, still = false): this {
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
    return this;
  }

  /** Where the point lies that is `back` mm behind its front; null while its place is not known. */
  middle(back = 0): Spot | null {
    let rest = this.s - back;
    for (let i = 0; i + 1 < this.path.length; i++) {
      const way = this.ways[i];
      if (!way) break;
      if (rest <= way.edge.length || i + 2 === this.path.length) return behind(this.track.along(way, rest), -rest);
      rest -= way.edge.length;
    }
    const first = this.path[0];
    const spot = first === undefined ? undefined : this.track.spot(first);
    return spot ? behind(spot, back - this.s) : null;
  }

  /** Whether the drawn place still differs from the reported one. */
  get busy(): boolean {
    return this.moving || Math.abs(this.reported - this.s) > 5;
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
    const onward = this.path.indexOf(barcode, this.here);
    const known = onward >= 0 ? onward : this.path.lastIndexOf(barcode);
    if (known >= 0) {
      this.lay([...this.path.slice(0, known), ...ahead]);
      return known;
    }
    const from = this.index();
    const way = this.track.path(this.path[from] as string, barcode);
    if (!way) return null;
    const path = [...this.path.slice(0, from), ...way];
    this.lay([...path.slice(0, -1), ...ahead]);
    return this.lengthTo(path.length - 1) - this.s > JUMP ? null : path.length - 1;
  }

  private learn(travelled: number, took: number): void {
    if (took < 0.02) return;
    const measured = Math.min(travelled / took, this.topSpeed);
    this.pace = this.pace === 0 ? measured : this.pace * 0.5 + measured * 0.5;
  }

  /** The barcodes before one, as long as there is only one way to have come. */
  private tail(barcode: string): string[] {
    const path: string[] = [];
    for (let length = 0, here = barcode; length < TAIL; ) {
      const [edge, other] = this.track.before.get(here) ?? [];
      if (!edge || other || path.includes(edge.start)) break;
      path.unshift(edge.start);
      length += edge.length;
      here = edge.start;
    }
    return path;
  }

  private lay(path: string[]): void {
    this.path = path;
    this.ways = path.slice(1).map((end, i) => this.track.way(path[i] as string, end));
  }

  private lengthTo(index: number): number {
    let sum = 0;
    for (let i = 0; i < index; i++) sum += this.ways[i]?.edge.length ?? 0;
    return sum;
  }

  /** Which edge of the path the drawn front is on. */
  private index(): number {
    let i = 0;
    while (i + 2 < this.path.length && this.lengthTo(i + 1) <= this.s) i++;
    return i;
  }

  private trim(): void {
    while (this.path.length > 2) {
      const length = this.ways[0]?.edge.length ?? 0;
      if (this.s < length + TAIL || this.reported < length) return;
      this.path.shift();
      this.ways.shift();
      this.here = Math.max(0, this.here - 1);
      this.s -= length;
      this.reported -= length;
    }
  }
}

/** Straight back from a place, for as long as there is no track known behind it. */
export function behind(spot: Spot, mm: number): Spot {
  const more = Math.max(0, mm);
  return { x: spot.x - Math.cos(spot.angle) * more, y: spot.y - Math.sin(spot.angle) * more, angle: spot.angle };
}
