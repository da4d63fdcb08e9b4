/** What all drawing shares: colours, letters, and the shape of what is drawn. */
import type { DoorMark } from "../doors";
import type { Cluster, Mark } from "../places";
import type { DeviceLook } from "../shows";
import type { Selection } from "../store";
import type { Track } from "../track";
import type { Device, Layout, Station } from "../types";

export const INK = {
  ground: "#0a1017",
  rail: "#33475b",
  tape: "#2c5254",
  core: "#0f1822",
  arrow: "#6d879f",
  zone: "#c98a2b",
  mark: "#5b7389",
  frame: "#1d2a38",
  text: "#9fb3c6",
  park: "#7fd1a8",
  carrier: "#f7e3b0",
  reserved: "#ffd24d",
  closed: "#ff5c5c",
  picked: "#ffffff",
};
const LETTERS = '"Segoe UI", Roboto, "Noto Sans KR", "Malgun Gothic", Arial, system-ui, sans-serif';

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
