/** What all drawing shares: colours, letters, and the shape of what is drawn. */
import type { DoorMark } from "../doors";
import type { Cluster, Mark } from "../places";
import { DEVICE_LOOKS, type DeviceLook, LOOKS, type Look } from "../shows";
import type { Selection } from "../store";
import type { Track } from "../track";
import type { Device, Layout, Station } from "../types";

const NAMES = [
  "ground",
  "rail",
  "tape",
  "core",
  "arrow",
  "zone",
  "soft",
  "mark",
  "frame",
  "text",
  "faint",
  "park",
  "carrier",
  "reserved",
  "closed",
  "picked",
  "plate",
  "plan",
] as const;
type Name = (typeof NAMES)[number];

/** The colours of the present theme, read from the style sheet by `dip`. */
export const INK = Object.fromEntries(NAMES.map((name) => [name, "#888"])) as Record<Name, string>;
export const LOOK_INK = { ...LOOKS } as Record<Look, string>;
export const DEVICE_INK = { ...DEVICE_LOOKS } as Record<DeviceLook, string>;
/** From little to much; a scale that is also told apart without red and green. */
export const HEAT: string[] = [];
const STEPS = 6;

/** Take the colours of the theme that is worn now. */
export function dip(): void {
  const style = getComputedStyle(document.documentElement);
  const of = (name: string): string => style.getPropertyValue(name).trim() || "#888888";
  for (const name of NAMES) INK[name] = of(`--ink-${name}`);
  for (const look of Object.keys(LOOK_INK) as Look[]) LOOK_INK[look] = of(`--look-${look}`);
  for (const look of Object.keys(DEVICE_INK) as DeviceLook[]) DEVICE_INK[look] = of(`--device-${look}`);
  HEAT.splice(0, HEAT.length, ...Array.from({ length: STEPS }, (_, i) => of(`--heat-${i + 1}`)));
}

const LETTERS = '"Segoe UI", Roboto, "Noto Sans KR", "Malgun Gothic", "NanumGothic", Arial, system-ui, sans-serif';

export type Ctx = CanvasRenderingContext2D;

export interface Scene {
  layout: Layout;
  track: Track;
  marks: Mark[];
  clusters: Cluster[];
  doors: DoorMark[];
}

/** What is known of the things drawn, at this moment. */
export interface Now {
  station(id: string): Station | undefined;
  device(id: string): Device | undefined;
  /** How a door, buffer or charger looks. */
  look(id: string): DeviceLook;
  picked: Selection;
  /** Whether zones are shown. */
  zones: boolean;
}

export function font(px: number, weight = 400): string {
  return `${weight} ${px}px ${LETTERS}`;
}

export function text(ctx: Ctx, words: string, x: number, y: number, colour: string, letters: string): void {
  ctx.font = letters;
  ctx.textAlign = "center";
  ctx.fillStyle = colour;
  ctx.fillText(words, x, y);
}

const widths = new Map<string, number>();

/** Width of words in px; measured once, since names do not change. */
export function widthOf(ctx: Ctx, words: string, letters: string): number {
  const key = `${letters}${words}`;
  const known = widths.get(key);
  if (known !== undefined) return known;
  if (widths.size > 20_000) widths.clear();
  ctx.font = letters;
  const { width } = ctx.measureText(words);
  widths.set(key, width);
  return width;
}
