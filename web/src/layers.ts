/** What lies over the track on the map, and what of it is shown. */
import { signal } from "@preact/signals";
import type { HeatKind } from "./heat";

export const LAYERS = ["grants", "zones", "closures", "holds"] as const;
export type Layer = (typeof LAYERS)[number];

const KEPT = "hoistway.layers";

function kept(): Record<Layer, boolean> {
  const all = Object.fromEntries(LAYERS.map((layer) => [layer, true])) as Record<Layer, boolean>;
  try {
    const found = JSON.parse(localStorage.getItem(KEPT) ?? "{}") as Record<string, unknown>;
    for (const layer of LAYERS) if (typeof found[layer] === "boolean") all[layer] = found[layer];
  } catch {
    /* What is kept is not ours: all are shown. */
  }
  return all;
}

export const layers = signal(kept());
/** Which heat is shown over the track; none at first. */
export const heatShown = signal<HeatKind | null>(null);
/** Over how many hours it is counted; 0: since this page was opened. */
export const heatHours = signal(1);
export const HEAT_HOURS = [0, 1, 8, 24] as const;
/** Whether the chosen vehicle is kept in the middle of the map. */
export const following = signal(false);

export function show(layer: Layer, on: boolean): void {
  layers.value = { ...layers.value, [layer]: on };
  localStorage.setItem(KEPT, JSON.stringify(layers.value));
}
