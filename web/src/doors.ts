/** Doors: where they stand across the track. Pure. */
import type { Track } from "./track";
import type { Layout } from "./types";

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
