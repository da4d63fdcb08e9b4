/** Where the marks of stations and chargers lie beside the track, and what is written at them. Pure. */
import { NATURAL } from "./natural";
import type { Spot, Track } from "./track";
import type { Layout } from "./types";

export interface Mark {
  id: string;
  kind: string;
  barcode: string;
  x: number;
  y: number;
  angle: number;
  /** Unit vector from the track to the mark. */
  nx: number;
  ny: number;
  short: string;
}

/** Stations of one machine, side by side: framed and named together. */
export interface Cluster {
  name: string;
  marks: Mark[];
}

export const MARK = 460;
const OFFSET: Record<string, number> = { port: 720, agv_buffer: 1150, charger: 1150 };
const SIDE = 640;
const NEAR = 2200;
/** Room beyond this makes no difference, mm. */
const FURTHEST = 4000;

interface Stand {
  id: string;
  kind: string;
  barcode: string;
  spot: Spot;
}

/** Stations with the same first part of the name, of one kind, next to each other, on one side of the track. */
export function clustersOf(layout: Layout, track: Track): Cluster[] {
  const groups: { name: string; stands: Stand[] }[] = [];
  const named = new Map<string, typeof groups>();
  const sides = sidesOf(layout);
  const chargers = layout.chargers.map(({ id, barcode }) => ({ id, kind: "charger", barcode }));
  for (const { id, kind, barcode } of [...layout.stations, ...chargers]) {
    const spot = track.spot(barcode);
    if (!spot) continue;
    const cut = id.lastIndexOf("-");
    const name = cut > 0 ? id.slice(0, cut) : id;
    const near = (s: Stand): boolean => s.kind === kind && Math.hypot(s.spot.x - spot.x, s.spot.y - spot.y) < NEAR;
    const mates = named.get(name)?.find((group) => group.stands.some(near));
    if (mates) mates.stands.push({ id, kind, barcode, spot });
    else {
      const group = { name, stands: [{ id, kind, barcode, spot }] };
      groups.push(group);
      named.set(name, [...(named.get(name) ?? []), group]);
    }
  }
  return groups.map(({ name, stands }) => {
    const marks = beside(stands, sides, track);
    return { name: (named.get(name)?.length ?? 0) > 1 ? toldApart(name, marks) : name, marks };
  });
}

/** The name of one of several groups that begin alike: with its first and its last station. */
function toldApart(name: string, marks: Mark[]): string {
  const shorts = marks.map(({ short }) => short).filter(Boolean).sort(NATURAL.compare);
  const [first, last] = [shorts[0], shorts.at(-1)];
  if (!first) return name;
  return first === last ? `${name}-${first}` : `${name}-${first}…${last}`;
}

/** Barcodes that have a side buffer, by its side. */
type Sides = Record<"sbfl" | "sbfr", ReadonlySet<string>>;

function sidesOf(layout: Layout): Sides {
  const of = (kind: string): Set<string> =>
    new Set(layout.stations.filter((station) => station.kind === kind).map((station) => station.barcode));
  return { sbfl: of("sbfl"), sbfr: of("sbfr") };
}

function beside(stands: Stand[], sides: Sides, track: Track): Mark[] {
  const left = onLeft(stands, sides, track);
  return stands.map(({ id, kind, barcode, spot }) => {
    const sign = left ? 1 : -1;
    const [nx, ny] = [Math.sin(spot.angle) * sign, -Math.cos(spot.angle) * sign];
    const offset = OFFSET[kind] ?? SIDE;
    const short = id.includes("-") ? id.slice(id.lastIndexOf("-") + 1) : "";
    return { id, kind, barcode, x: spot.x + nx * offset, y: spot.y + ny * offset, angle: spot.angle, nx, ny, short };
  });
}

/** Side buffers have their side; everything else is drawn where there is more room. */
function onLeft(stands: Stand[], sides: Sides, track: Track): boolean {
  const kind = stands[0]?.kind;
  if (kind === "sbfl" || kind === "sbfr") return kind === "sbfl";
  const taken = (side: "sbfl" | "sbfr"): boolean => stands.some((stand) => sides[side].has(stand.barcode));
  if (taken("sbfl") !== taken("sbfr")) return taken("sbfr");
  const least = (sign: number): number => Math.min(...stands.map(({ spot }) => room(track, spot, sign)));
  return least(1) > least(-1) + 1;
}

/** How far the nearest other track is on that side (1 left, -1 right), mm; bounded. */
function room(track: Track, spot: Spot, sign: number): number {
  const [nx, ny] = [Math.sin(spot.angle) * sign, -Math.cos(spot.angle) * sign];
  let least = FURTHEST;
  for (const point of track.grid.around(spot.x, spot.y, FURTHEST + 1500)) {
    const [dx, dy] = [point.x - spot.x, point.y - spot.y];
    const across = dx * nx + dy * ny;
    const along = Math.abs(dx * ny - dy * nx);
    if (across > 300 && across < least && along < 1500) least = across;
  }
  return least;
}
