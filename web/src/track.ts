/** The track as drawn: edges as curves, places along them, and the way between two barcodes. Pure. */
import { Grid } from "./grid";
import type { Layout, LayoutEdge } from "./types";
import type { Box } from "./view";

export interface Spot {
  x: number;
  y: number;
  /** Heading in radians, clockwise from east: y grows downwards. */
  angle: number;
}

export interface Vec {
  x: number;
  y: number;
}

/** One edge: `pts` are places along its curve, `at` the distance of each from its start on paper. */
export interface Way {
  edge: LayoutEdge;
  pts: Vec[];
  at: number[];
  /** What it takes up on paper. */
  box: Box;
}

const STEPS = 8;
const minus = (a: Vec, b: Vec): Vec => ({ x: a.x - b.x, y: a.y - b.y });
const unit = (v: Vec): Vec => {
  const size = Math.hypot(v.x, v.y) || 1;
  return { x: v.x / size, y: v.y / size };
};
const dot = (a: Vec, b: Vec): number => a.x * b.x + a.y * b.y;

export class Track {
  readonly points = new Map<string, Vec & { park: boolean }>();
  readonly ways = new Map<string, Way>();
  readonly next = new Map<string, LayoutEdge[]>();
  readonly before = new Map<string, LayoutEdge[]>();
  /** Barcodes on the floor: tape of AGVs, and all that hangs together with it. */
  readonly floor: ReadonlySet<string>;
  readonly box: Box;
  /** Barcodes by where they are. */
  readonly grid = new Grid<Vec>();
  private readonly from = new Map<string, Way[]>();

  constructor(layout: Layout) {
    for (const { barcode, x, y, park } of layout.points) {
      this.points.set(barcode, { x, y, park });
      this.grid.put({ x, y });
    }
    for (const edge of layout.edges) {
      if (!this.points.has(edge.start) || !this.points.has(edge.end)) continue;
      push(this.next, edge.start, edge);
      push(this.before, edge.end, edge);
    }
    for (const edges of this.next.values()) {
      for (const edge of edges) {
        const way = this.draw(edge);
        this.ways.set(keyOf(edge), way);
        push(this.from, edge.start, way);
      }
    }
    this.floor = this.connected([
      ...layout.stations.filter((station) => station.kind === "agv_buffer").map((station) => station.barcode),
      ...layout.chargers.map((charger) => charger.barcode),
    ]);
    const xs = layout.points.map((p) => p.x);
    const ys = layout.points.map((p) => p.y);
    this.box = {
      x0: least(xs, Math.min),
      x1: least(xs, Math.max),
      y0: least(ys, Math.min),
      y1: least(ys, Math.max),
    };
  }

  way(start: string, end: string): Way | undefined {
    return this.from.get(start)?.find((way) => way.edge.end === end);
  }

  /** Whether the same piece is driven the other way, too. */
  twoWay(edge: LayoutEdge): boolean {
    return this.way(edge.end, edge.start) !== undefined;
  }

  /** Place at `mm` of travel along an edge. */
  along(way: Way, mm: number): Spot {
    const total = way.at.at(-1) ?? 0;
    const want = Math.min(Math.max(mm / way.edge.length, 0), 1) * total;
    let i = 1;
    while (i < way.at.length - 1 && (way.at[i] ?? 0) < want) i++;
    const a = way.pts[i - 1] as Vec;
    const b = way.pts[i] as Vec;
    const from = way.at[i - 1] ?? 0;
    const f = (want - from) / ((way.at[i] ?? 0) - from || 1);
    const angle = Math.atan2(b.y - a.y, b.x - a.x);
    return { x: a.x + (b.x - a.x) * f, y: a.y + (b.y - a.y) * f, angle };
  }

  /** Place of a barcode, heading as one that has arrived there. */
  spot(barcode: string): Spot | undefined {
    const point = this.points.get(barcode);
    if (!point) return undefined;
    const tangent = this.tangent(barcode, this.before.get(barcode)?.[0] ?? this.next.get(barcode)?.[0]);
    return { x: point.x, y: point.y, angle: Math.atan2(tangent.y, tangent.x) };
  }

  /** Barcodes from `start` to `end` by the fewest edges, both included; undefined if more than `limit` edges. */
  path(start: string, end: string, limit = 24): string[] | undefined {
    if (start === end) return [start];
    const from = new Map<string, string>([[start, ""]]);
    let edge = [start];
    for (let depth = 0; depth < limit && edge.length > 0; depth++) {
      const further: string[] = [];
      for (const here of edge) {
        for (const step of this.next.get(here) ?? []) {
          if (from.has(step.end)) continue;
          from.set(step.end, here);
          if (step.end === end) return trace(from, end);
          further.push(step.end);
        }
      }
      edge = further;
    }
    return undefined;
  }

  /** All barcodes that hang together with these, whichever way the track is driven. */
  private connected(starts: string[]): Set<string> {
    const found = new Set(starts.filter((start) => this.points.has(start)));
    for (const here of found) {
      for (const edge of this.next.get(here) ?? []) found.add(edge.end);
      for (const edge of this.before.get(here) ?? []) found.add(edge.start);
    }
    return found;
  }

  private chord(edge: LayoutEdge): Vec {
    return minus(this.points.get(edge.end) as Vec, this.points.get(edge.start) as Vec);
  }

  /** Direction at a barcode for an edge that ends or starts there: that of straight track if there is any, else of the arc. */
  private tangent(barcode: string, own: LayoutEdge | undefined): Vec {
    if (!own) return { x: 1, y: 0 };
    const mine = this.chord(own);
    const ins = this.before.get(barcode) ?? [];
    const outs = this.next.get(barcode) ?? [];
    const others = own.end === barcode ? outs : ins;
    const best = (edges: LayoutEdge[]): LayoutEdge | undefined =>
      edges.toSorted((a, b) => dot(unit(this.chord(b)), unit(mine)) - dot(unit(this.chord(a)), unit(mine)))[0];
    const straight = best([...ins, ...outs].filter((edge) => !edge.curve && edge !== own));
    if (!own.curve) return unit(mine);
    if (straight && dot(unit(this.chord(straight)), unit(mine)) > 0) return unit(this.chord(straight));
    const other = best(others);
    if (!other) return unit(mine);
    const theirs = this.chord(other);
    const [l1, l2] = [Math.hypot(mine.x, mine.y) || 1, Math.hypot(theirs.x, theirs.y) || 1];
    return unit({ x: mine.x / l1 / l1 + theirs.x / l2 / l2, y: mine.y / l1 / l1 + theirs.y / l2 / l2 });
  }

  private draw(edge: LayoutEdge): Way {
    const a = this.points.get(edge.start) as Vec;
    const b = this.points.get(edge.end) as Vec;
    const pts = edge.curve ? arc(a, b, this.tangent(edge.start, edge), this.tangent(edge.end, edge)) : [a, b];
    const at = [0];
    for (let i = 1; i < pts.length; i++) {
      const step = minus(pts[i] as Vec, pts[i - 1] as Vec);
      at.push((at[i - 1] ?? 0) + Math.hypot(step.x, step.y));
    }
    const [xs, ys] = [pts.map((p) => p.x), pts.map((p) => p.y)];
    const box = { x0: Math.min(...xs), x1: Math.max(...xs), y0: Math.min(...ys), y1: Math.max(...ys) };
    return { edge, pts, at, box };
  }
}

/** A cubic with these directions at its ends, as near to an arc of a circle as a cubic gets. */
function arc(a: Vec, b: Vec, ta: Vec, tb: Vec): Vec[] {
  const chord = Math.hypot(b.x - a.x, b.y - a.y);
  const turn = Math.acos(Math.min(1, Math.max(-1, dot(ta, tb))));
  const reach = turn < 0.01 ? chord / 3 : (chord * (2 / 3) * Math.tan(turn / 4)) / Math.sin(turn / 2);
  const c1 = { x: a.x + ta.x * reach, y: a.y + ta.y * reach };
  const c2 = { x: b.x - tb.x * reach, y: b.y - tb.y * reach };
  return Array.from({ length: STEPS + 1 }, (_, i) => {
    const t = i / STEPS;
    const u = 1 - t;
    const [k0, k1, k2, k3] = [u * u * u, 3 * u * u * t, 3 * u * t * t, t * t * t];
    return { x: k0 * a.x + k1 * c1.x + k2 * c2.x + k3 * b.x, y: k0 * a.y + k1 * c1.y + k2 * c2.y + k3 * b.y };
  });
}

export function keyOf(edge: LayoutEdge): string {
  return `${edge.start}>${edge.end}`;
}

function trace(from: Map<string, string>, end: string): string[] {
  const path = [end];
  for (let at = from.get(end); at; at = from.get(at)) path.push(at);
  return path.reverse();
}

function push<K, V>(map: Map<K, V[]>, key: K, value: V): void {
  const list = map.get(key);
  if (list) list.push(value);
  else map.set(key, [value]);
}

function least(values: number[], pick: (a: number, b: number) => number): number {
  return values.length ? values.reduce((a, b) => pick(a, b)) : 0;
}
