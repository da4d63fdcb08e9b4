/** Finds room for names, so that none lies over another or over what it names. */
import type { Box } from "../view";

export interface Place {
  x: number;
  y: number;
}

/** Height of a line of letters above and below its base line, px. */
const ABOVE = 10;
const BELOW = 3;

export function boxOf(place: Place, width: number): Box {
  return { x0: place.x - width / 2 - 2, x1: place.x + width / 2 + 2, y0: place.y - ABOVE, y1: place.y + BELOW };
}

export class Labels {
  private readonly taken: Box[] = [];

  /** Keep a box free of names. */
  block(box: Box): void {
    this.taken.push(box);
  }

  free(box: Box): boolean {
    return !this.taken.some((b) => b.x0 < box.x1 && b.x1 > box.x0 && b.y0 < box.y1 && b.y1 > box.y0);
  }

  /** Take the first place (middle of its base line) where a name of that width fits; returns which, -1: nowhere. */
  take(places: Place[], width: number): number {
    const which = places.findIndex((place) => this.free(boxOf(place, width)));
    const place = places[which];
    if (place) this.block(boxOf(place, width));
    return which;
  }

  get boxes(): readonly Box[] {
    return this.taken;
  }
}
