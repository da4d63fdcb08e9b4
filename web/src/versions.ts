/** Versions of the plant, as the server tells them, and where their differences lie on the plan. */
import type { Layout } from "./types";

export interface Version {
  number: number;
  state: "staged" | "awaited" | "active" | "former" | "rejected";
  origin: "file" | "upload";
  at: string;
  actor: string;
  reason: string;
  size: number;
  activated: string | null;
  activated_by: string | null;
  why: string;
  before: number | null;
  note: string;
  pruned: string | null;
}

export interface Change {
  what: string;
  how: "added" | "removed" | "changed" | "moved" | "renamed";
  name: string;
  text: string;
  before: unknown;
  after: unknown;
}

export interface Break {
  what: string;
  name: string;
  text: string;
  remedy: string;
}

export interface Difference {
  version: number;
  against: number;
  changes: Change[];
  breaks: Break[];
}

export interface Impact {
  ready: boolean;
  in_the_way: Break[];
  lost: Break[];
  lacking: Break[];
}

export interface Finding {
  line: number;
  column: number;
  severity: string;
  message: string;
  remedy: string;
}

export type Spot = readonly [number, number];
export type How = "same" | "added" | "removed" | "changed";

export interface Drawn {
  /** SVG path data of the track, by what becomes of it. */
  track: Record<How, string>;
  marks: { at: Spot; how: How; name: string; station: boolean }[];
  box: { x: number; y: number; width: number; height: number };
}

const HOW: Record<Change["how"], How> = { added: "added", removed: "removed", changed: "changed", moved: "changed", renamed: "changed" };
const ROOM = 0.04;

function field<T>(value: unknown, name: string): T | undefined {
  return value !== null && typeof value === "object" ? ((value as Record<string, unknown>)[name] as T) : undefined;
}

/** Lay a difference over the plan that runs: track and marks, each as it is, comes, goes or changes. */
export function drawn(layout: Layout, changes: Change[]): Drawn {
  const spots = new Map<string, Spot>(layout.points.map((point) => [point.barcode, [point.x, point.y]]));
  const marks: Drawn["marks"] = [];
  for (const change of changes.filter(({ what }) => what === "barcode")) {
    const [x, y] = [field<number>(change.after, "x"), field<number>(change.after, "y")];
    const moved = change.how === "moved" ? (change.after as number[]) : null;
    const at: Spot | undefined = x !== undefined && y !== undefined ? [x, y] : moved ? [moved[0] as number, moved[1] as number] : spots.get(change.name);
    if (!at) continue;
    if (change.how === "added") spots.set(change.name, at);
    if (change.how === "renamed" && typeof change.after === "string") spots.set(change.after, at);
    marks.push({ at, how: HOW[change.how], name: change.name, station: false });
  }
  for (const change of changes.filter(({ what }) => what === "station")) {
    const barcode = field<string>(change.after, "barcode") ?? field<string>(change.before, "barcode");
    const at = barcode === undefined ? undefined : spots.get(barcode);
    if (at) marks.push({ at, how: HOW[change.how], name: change.name, station: true });
  }
  return { track: trackOf(layout, changes, spots), marks, box: boxOf([...spots.values()]) };
}

function trackOf(layout: Layout, changes: Change[], spots: Map<string, Spot>): Record<How, string> {
  const pieces: Record<How, string[]> = { same: [], added: [], removed: [], changed: [] };
  const draw = (how: How, start: string, end: string): void => {
    const [from, to] = [spots.get(start), spots.get(end)];
    if (from && to) pieces[how].push(`M${from[0]} ${from[1]}L${to[0]} ${to[1]}`);
  };
  const other = new Set<string>();
  for (const change of changes.filter(({ what }) => what === "track")) {
    const edge = change.after ?? change.before;
    const [start, end] = [field<string>(edge, "start") ?? "", field<string>(edge, "end") ?? ""];
    other.add(`${start} ${end}`);
    draw(HOW[change.how], start, end);
  }
  for (const { start, end } of layout.edges) if (!other.has(`${start} ${end}`)) draw("same", start, end);
  return { same: pieces.same.join(""), added: pieces.added.join(""), removed: pieces.removed.join(""), changed: pieces.changed.join("") };
}

function boxOf(spots: Spot[]): Drawn["box"] {
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of spots) {
    left = Math.min(left, x);
    right = Math.max(right, x);
    top = Math.min(top, y);
    bottom = Math.max(bottom, y);
  }
  if (spots.length === 0) return { x: 0, y: 0, width: 1, height: 1 };
  const room = Math.max(right - left, bottom - top, 1) * ROOM;
  return { x: left - room, y: top - room, width: right - left + 2 * room, height: bottom - top + 2 * room };
}
