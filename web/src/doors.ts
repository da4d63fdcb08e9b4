/** Doors: where they stand across the track, and who is in them or will pass. Pure. */
import type { Track } from "./track";
import type { Device, Layout, LayoutDoor, Vehicle } from "./types";

/** One passage of a door: the bar is drawn across the track there. */
export interface DoorMark {
  id: string;
  x: number;
  y: number;
  /** Heading of the track through it. */
  angle: number;
  /** The door's name stands at its first passage. */
  named: boolean;
}

export function doorMarks(layout: Layout, track: Track): DoorMark[] {
  return layout.doors.flatMap((door) => {
    const ways = door.passages.flatMap(([a, b]) => track.way(a, b) ?? track.way(b, a) ?? []);
    return ways.map((way, i) => ({ id: door.id, ...track.along(way, way.edge.length / 2), named: i === 0 }));
  });
}

/** Vehicles in a door or granted the way through it: as the server says, or as their track says. */
export function passersOf(device: Device | undefined, door: LayoutDoor | undefined, vehicles: Iterable<Vehicle>): string[] {
  if (device?.vehicles) return device.vehicles;
  if (!door) return [];
  return [...vehicles].filter((vehicle) => passes(vehicle, door)).map((vehicle) => vehicle.id);
}

function passes(vehicle: Vehicle, door: LayoutDoor): boolean {
  const held = new Set([...vehicle.covered, ...vehicle.granted, ...(vehicle.barcode ? [vehicle.barcode] : [])]);
  return door.passages.some(([a, b]) => held.has(a) && held.has(b));
}
