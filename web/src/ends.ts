/** Which ends a transfer can join: hoists serve ports and side buffers, AGVs their own buffers. Pure. */
import type { Layout } from "./types";

export type World = "hoist" | "agv";

export const worldOfKind = (kind: string): World => (kind === "agv_buffer" ? "agv" : "hoist");

/** Who serves a station, or what a vehicle is; null: there is none of that name. */
export function worldOf(layout: Layout | null, id: string): World | null {
  const station = layout?.stations.find((one) => one.id === id);
  if (station) return worldOfKind(station.kind);
  const vehicle = layout?.vehicles.find((one) => one.id === id);
  return vehicle ? (vehicle.kind === "agv" ? "agv" : "hoist") : null;
}

/** Whether a job can go from one to the other; what is not chosen yet forbids nothing. */
export function joins(layout: Layout | null, source: string, destination: string): boolean {
  const [from, to] = [worldOf(layout, source), worldOf(layout, destination)];
  return from === null || to === null || from === to;
}
