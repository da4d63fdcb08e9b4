/** Things by where they are, in squares: whoever looks for neighbours need not look at all. Pure. */

const CELL = 5000;

export class Grid<T extends { x: number; y: number }> {
  private readonly cells = new Map<number, T[]>();

  put(thing: T): void {
    const key = keyOf(Math.floor(thing.x / CELL), Math.floor(thing.y / CELL));
    const there = this.cells.get(key);
    if (there) there.push(thing);
    else this.cells.set(key, [thing]);
  }

  /** All within a distance to either side, and some more. */
  *around(x: number, y: number, reach: number): Generator<T> {
    const to = (value: number): number => Math.floor(value / CELL);
    for (let i = to(x - reach); i <= to(x + reach); i++) {
      for (let j = to(y - reach); j <= to(y + reach); j++) yield* this.cells.get(keyOf(i, j)) ?? [];
    }
  }
}

/** One number for two: fabs are a few hundred squares wide. */
const keyOf = (i: number, j: number): number => (i + 32768) * 65536 + (j + 32768);
