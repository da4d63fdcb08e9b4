/** Chains of vehicles that wait for each other. */
import type { Vehicle } from "./types";

/** The vehicle at the end of a chain of waits, which does not wait for another itself; null: this one waits for none, or in a circle. */
export function rootOf(vehicle: Vehicle, find: (id: string) => Vehicle | undefined): Vehicle | null {
  const seen = new Set([vehicle.id]);
  let here = vehicle;
  for (let next = here.waits_for; next; next = here.waits_for) {
    const other = find(next);
    if (!other || seen.has(next)) return null;
    seen.add(next);
    here = other;
  }
  return here === vehicle ? null : here;
}
