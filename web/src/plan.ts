/** The way that the chosen vehicle would be led to its goal now: asked of the server when it changes goal or leaves that way. */
import { effect, signal } from "@preact/signals";
import { get } from "./api";
import { changes, inPast, selected, stations, vehicles } from "./store";
import type { RouteShown } from "./types";

/** Barcodes from the vehicle to its goal; empty: none is known. */
export const plan = signal<string[]>([]);

let asked = "";

async function ask(vehicle: string, from: string, to: string): Promise<void> {
  const now = `${vehicle} ${to}`;
  if (asked === now && plan.value.includes(from)) return;
  asked = now;
  try {
    const { items } = await get<{ items: RouteShown[] }>(`/layout/routes?${new URLSearchParams({ from, to })}`);
    if (asked === now) plan.value = items[0]?.barcodes ?? [];
  } catch {
    if (asked === now) plan.value = [];
  }
}

/** Keep it up to date; returns how to stop. */
export function begin(): () => void {
  return effect(() => {
    // The server would lead it round what is closed now, not then.
    const pick = inPast.value ? null : selected.value;
    void changes.vehicles.value;
    const vehicle = pick?.kind === "vehicle" ? vehicles.get(pick.id) : undefined;
    const goal = vehicle?.goal ? (stations.get(vehicle.goal)?.barcode ?? vehicle.goal) : null;
    if (vehicle?.barcode && goal && goal !== vehicle.barcode) void ask(vehicle.id, vehicle.barcode, goal);
    else {
      asked = "";
      if (plan.peek().length > 0) plan.value = [];
    }
  });
}
