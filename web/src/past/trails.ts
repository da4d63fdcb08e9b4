/**
 * Where to draw a vehicle at a moment of the past: it is known when it came by one barcode and when by the next, and it is drawn
 * between them by the time. Pure.
 */
import { behind } from "../glide";
import type { Spot, Track, Way } from "../track";
import type { Change, State } from "./reel";

/** From this moment on a vehicle was last seen at a barcode; `moves`: it drove. */
interface Mark {
  at: number;
  barcode: string | null;
  moves: boolean;
}

/** One that was not said to drive gets to its next barcode in the last so many seconds before it is there. */
const LEAP = 1;
/** Nothing drives faster; whatever would have is not drawn on its way, mm/s. */
const FASTEST = 6000;
/** Track known behind the barcode, so that the hull bends with the rail, mm. */
const TAIL = 1500;

class Course {
  readonly marks: Mark[] = [];
  /** The mark at or before the moment asked about last, and the ways about it. */
  private index = 0;
  private drawn = -1;
  private ways: Way[] = [];
  /** Where on those ways the barcode of the mark lies, and how far it is to the next, mm. */
  private offset = 0;
  private length = 0;

  add(mark: Mark): void {
    const last = this.marks.at(-1);
    if (last?.barcode === mark.barcode && last.moves === mark.moves) return;
    if (this.drawn === this.marks.length - 1) this.drawn = -1;
    this.marks.push(mark);
  }

  trim(before: number): void {
    let count = 0;
    while (count + 4 < this.marks.length && (this.marks[count + 3] as Mark).at < before) count++;
    if (count < 500) return;
    this.marks.splice(0, count);
    this.index = Math.max(0, this.index - count);
    this.drawn = -1;
  }

  spot(track: Track, at: number, back: number, still: boolean): Spot | null {
    const mark = this.find(at);
    if (!mark?.barcode || mark.at > at) return null;
    if (this.drawn !== this.index) this.draw(track, mark);
    const next = this.marks[this.index + 1];
    const s = this.offset + (still || !next ? 0 : this.length * share(mark, next, at));
    return place(track, this.ways, s - back) ?? rest(track, mark.barcode, back);
  }

  private find(at: number): Mark | undefined {
    const { marks } = this;
    let low = this.index;
    if ((marks[low]?.at ?? Number.POSITIVE_INFINITY) > at) low = 0;
    let step = 1;
    while ((marks[low + step]?.at ?? Number.POSITIVE_INFINITY) <= at) {
      low += step;
      step *= 2;
    }
    while (step >= 1) {
      if ((marks[low + step]?.at ?? Number.POSITIVE_INFINITY) <= at) low += step;
      step >>= 1;
    }
    this.index = low;
    return marks[low];
  }

  /** Lay out the ways by which it came, and the one that leads on. */
  private draw(track: Track, mark: Mark): void {
    this.drawn = this.index;
    const behindIt: Way[] = [];
    let length = 0;
    for (let i = this.index; i > 0 && length < TAIL; i--) {
      const [from, to] = [this.marks[i - 1]?.barcode, this.marks[i]?.barcode];
      if (from === to) continue;
      const ways = waysOf(track, from, to);
      if (ways.length === 0) break;
      behindIt.unshift(...ways);
      length += sum(ways);
    }
    if (length < TAIL) {
      const first = behindIt[0]?.edge.start ?? (mark.barcode as string);
      const more = only(track, first, TAIL - length);
      behindIt.unshift(...more);
      length += sum(more);
    }
    const next = this.marks[this.index + 1];
    let on = next && next.barcode !== mark.barcode ? waysOf(track, mark.barcode, next.barcode) : [];
    if (next && sum(on) > FASTEST * Math.max(next.at - mark.at, LEAP)) on = [];
    this.ways = [...behindIt, ...on];
    this.offset = length;
    this.length = sum(on);
  }
}

/** How much of the way to the next mark was behind it. */
function share(mark: Mark, next: Mark, at: number): number {
  const left = mark.moves ? mark.at : Math.max(mark.at, next.at - LEAP);
  return Math.min(Math.max((at - left) / Math.max(next.at - left, 0.001), 0), 1);
}

function sum(ways: Way[]): number {
  return ways.reduce((length, way) => length + way.edge.length, 0);
}

function waysOf(track: Track, from: string | null | undefined, to: string | null | undefined): Way[] {
  if (!from || !to) return [];
  const direct = track.way(from, to);
  if (direct) return [direct];
  const path = track.path(from, to, 12) ?? [];
  return path.slice(1).flatMap((end, i) => track.way(path[i] as string, end) ?? []);
}

/** The ways to a barcode for so many mm, as long as there is only one to have come. */
function only(track: Track, barcode: string, mm: number): Way[] {
  const ways: Way[] = [];
  for (let here = barcode, length = 0; length < mm; ) {
    const [edge, other] = track.before.get(here) ?? [];
    const way = edge && !other ? track.way(edge.start, here) : undefined;
    if (!edge || !way || ways.includes(way)) break;
    ways.unshift(way);
    length += edge.length;
    here = edge.start;
  }
  return ways;
}

function place(track: Track, ways: Way[], mm: number): Spot | null {
  const first = ways[0];
  if (!first) return null;
  if (mm < 0) return behind(track.along(first, 0), -mm);
  let left = mm;
  for (const way of ways) {
    if (left <= way.edge.length) return track.along(way, left);
    left -= way.edge.length;
  }
  return track.along(ways.at(-1) as Way, Number.POSITIVE_INFINITY);
}

function rest(track: Track, barcode: string, back: number): Spot | null {
  const spot = track.spot(barcode);
  return spot ? behind(spot, back) : null;
}

/** The courses of all vehicles, as far as the recording was fetched. */
export class Trails {
  private readonly courses = new Map<string, Course>();
  private readonly seen = new Map<string, { barcode: string | null; activity: string }>();

  clear(): void {
    this.courses.clear();
    this.seen.clear();
  }

  whole(at: number, state: State): void {
    for (const [id, vehicle] of Object.entries(state["vehicles"] ?? {})) this.take(at, id, vehicle);
  }

  change([at, topic, key, value]: Change): void {
    if (topic === "vehicles") this.take(at, key, value ?? { barcode: null });
  }

  trim(before: number): void {
    for (const course of this.courses.values()) course.trim(before);
  }

  /** Where the point lies that is `back` mm behind a vehicle's front at a moment; `still`: at its barcode. */
  spot(track: Track, id: string, at: number, back: number, still = false): Spot | null {
    return this.courses.get(id)?.spot(track, at, back, still) ?? null;
  }

  private take(at: number, id: string, value: Record<string, unknown>): void {
    if (!("barcode" in value) && !("activity" in value)) return;
    const seen = { ...(this.seen.get(id) ?? { barcode: null, activity: "" }), ...(value as object) };
    this.seen.set(id, { barcode: seen.barcode, activity: seen.activity });
    let course = this.courses.get(id);
    if (!course) this.courses.set(id, (course = new Course()));
    course.add({ at, barcode: seen.barcode, moves: seen.activity === "moving" });
  }
}
