/** Finds room for names, so that none lies over another or over what it names. */
import type { Box } from "../view";

export interface Place {
  x: number;
  y: number;
}

/** Height of a line of letters above and below its base line, px. */
const ABOVE = 10;
const BELOW = 3;
/** Boxes are looked up by the squares of this size that they lie in, px: hundreds of vehicles have names. */
const CELL = 64;

export function boxOf(place: Place, width: number): Box {
  return { x0: place.x - width / 2 - 2, x1: place.x + width / 2 + 2, y0: place.y - ABOVE, y1: place.y + BELOW };
}

export class Labels {
  private readonly cells = new Map<string, Box[]>();

  /** Keep a box free of names. */
  block(box: Box): void {
    for (const cell of cellsOf(box)) {
      const boxes = this.cells.get(cell);
      if (boxes) boxes.push(box);
      else this.cells.set(cell, [box]);
    }
  }

  free(box: Box): boolean {
    const touches = (b: Box): boolean => b.x0 < box.x1 && b.x1 > box.x0 && b.y0 < box.y1 && b.y1 > box.y0;
    return cellsOf(box).every((cell) => !this.cells.get(cell)?.some(touches));
  }

  /** Take the first place (middle of its base line) where a name of that width fits; returns which, -1: nowhere. */
  take(places: Place[], width: number): number {
    const which = places.findIndex((place) => this.free(boxOf(place, width)));
    const place = places[which];
    if (place) this.block(boxOf(place, width));
    return which;
  }
}

function cellsOf({ x0, y0, x1, y1 }: Box): string[] {
  const cells: string[] = [];
  for (let x = Math.floor(x0 / CELL); x <= Math.floor(x1 / CELL); x++) {
    for (let y = Math.floor(y0 / CELL); y <= Math.floor(y1 / CELL); y++) cells.push(`${x}/${y}`);
  }
  return cells;
}
