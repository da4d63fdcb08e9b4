/** Where the marks of stations lie beside the track, and what is written at them. Pure. */
import type { Track } from "./track";
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
const OFFSET = { port: 720, side: 640 };
const NEAR = 1700;

export function marksOf(layout: Layout, track: Track): Mark[] {
  const taken = new Set(layout.stations.filter((s) => s.kind !== "port").map((s) => `${s.barcode}/${s.kind}`));
  return layout.stations.flatMap((station) => {
    const spot = track.spot(station.barcode);
    if (!spot) return [];
    const left = { x: Math.sin(spot.angle), y: -Math.cos(spot.angle) };
    const goesLeft = station.kind === "sbfl" || (station.kind === "port" && portLeft(station.barcode, spot, left));
    const side = goesLeft ? left : { x: -left.x, y: -left.y };
    const offset = station.kind === "port" ? OFFSET.port : OFFSET.side;
    const short = station.id.includes("-") ? station.id.slice(station.id.lastIndexOf("-") + 1) : "";
    const { id, kind, barcode } = station;
    const at = { x: spot.x + side.x * offset, y: spot.y + side.y * offset };
    return [{ id, kind, barcode, ...at, angle: spot.angle, nx: side.x, ny: side.y, short }];
  });

  function portLeft(barcode: string, spot: { x: number; y: number }, left: { x: number; y: number }): boolean {
    const [onLeft, onRight] = [taken.has(`${barcode}/sbfl`), taken.has(`${barcode}/sbfr`)];
    if (onLeft !== onRight) return onRight;
    return room(track, spot, left) > room(track, spot, { x: -left.x, y: -left.y }) + 1;
  }
}

/** How far the nearest other track is on that side, mm; bounded. */
function room(track: Track, spot: { x: number; y: number }, side: { x: number; y: number }): number {
  let least = 4000;
  for (const point of track.points.values()) {
    const [dx, dy] = [point.x - spot.x, point.y - spot.y];
    const across = dx * side.x + dy * side.y;
    const along = Math.abs(dx * side.y - dy * side.x);
    if (across > 300 && across < least && along < 1500) least = across;
  }
  return least;
}

export function clustersOf(marks: Mark[]): Cluster[] {
  const clusters: Cluster[] = [];
  for (const mark of marks) {
    const name = mark.short ? mark.id.slice(0, mark.id.lastIndexOf("-")) : mark.id;
    const mate = clusters.find(
      (cluster) =>
        cluster.name === name &&
        cluster.marks.some((m) => m.kind === mark.kind && Math.hypot(m.x - mark.x, m.y - mark.y) < NEAR),
    );
    if (mate) mate.marks.push(mark);
    else clusters.push({ name, marks: [mark] });
  }
  return clusters;
}
