/** The recording as it was fetched: whole states now and then, and what changed between. Pure: the caller brings pieces and moments. */

/** Moment (UTC seconds), topic, key, and the object: of a vehicle what has changed, null where it is gone. */
export type Change = [at: number, topic: string, key: string, value: Record<string, unknown> | null];
/** Objects by topic and key. */
export type State = Record<string, Record<string, Record<string, unknown>>>;

export interface Piece {
  id: number;
  begin: number;
  end: number;
  /** The whole state at the begin; or else there are changes. */
  state?: State;
  changes?: Change[];
}

export interface Pieces {
  items: { id: number; kind: "state" | "changes"; begin: number; end: number; size: number }[];
  more: boolean;
}

/** Where what is listed in the first line of an answer begins, and the line itself. */
export function headOf(body: Uint8Array): { head: Pieces; from: number } {
  const end = body.indexOf(10);
  return { head: JSON.parse(new TextDecoder().decode(body.subarray(0, end))) as Pieces, from: end + 1 };
}

async function unpacked(body: Uint8Array<ArrayBuffer>): Promise<unknown> {
  const plain = new Blob([body]).stream().pipeThrough(new DecompressionStream("deflate"));
  return (await new Response(plain).json()) as unknown;
}

/** Give the pieces of an answer one after the other, so that nothing else has to wait for all of them. */
export async function* piecesOf(body: Uint8Array<ArrayBuffer>): AsyncGenerator<Piece> {
  const { head, from } = headOf(body);
  let at = from;
  for (const { id, kind, begin, end, size } of head.items) {
    const content = await unpacked(body.subarray(at, at + size));
    at += size;
    yield kind === "state" ? { id, begin, end, state: content as State } : { id, begin, end, changes: content as Change[] };
  }
}

/** What a change makes of an object. */
export function changed(before: Record<string, unknown> | undefined, [, topic, , value]: Change): Record<string, unknown> | null {
  return topic === "vehicles" && value !== null ? { ...before, ...value } : value;
}

export interface Screen {
  /** Show this and nothing else. */
  whole(state: State): void;
  change(change: Change): void;
}

/** A whole state is shown on the way at most so often, s. */
const ANEW = 55;
/** So many changes are kept before those that are furthest back go. */
const MOST = 250_000;

export class Reel {
  private pieces: Piece[] = [];
  private count = 0;
  /** What comes next: the piece, and the change in it. */
  private index = 0;
  private within = 0;
  /** What is shown; NaN: nothing yet. */
  private now = Number.NaN;
  /** Of when the last whole state that was shown is. */
  private wholeAt = Number.NEGATIVE_INFINITY;
  /** All that happened before this moment is here, s. */
  until = Number.NEGATIVE_INFINITY;

  clear(): void {
    this.pieces = [];
    this.count = this.index = this.within = 0;
    this.now = Number.NaN;
    this.wholeAt = Number.NEGATIVE_INFINITY;
    this.until = Number.NEGATIVE_INFINITY;
  }

  /** Put a piece behind the others. */
  add(piece: Piece): void {
    this.pieces.push(piece);
    this.count += piece.changes?.length ?? 0;
    this.until = Math.max(this.until, piece.end);
  }

  get last(): number | null {
    return this.pieces.at(-1)?.id ?? null;
  }

  /** The first moment that can be shown. */
  get begin(): number {
    return this.pieces[0]?.begin ?? Number.POSITIVE_INFINITY;
  }

  holds(at: number): boolean {
    return this.begin <= at && at <= this.until;
  }

  /** Show a moment: go on to it if nothing whole lies between, else make it of the whole state before it. */
  seek(at: number, screen: Screen): void {
    let from = 0;
    this.pieces.forEach((piece, i) => {
      if (piece.state && piece.begin <= at) from = i;
    });
    if (this.now <= at && from < this.index) this.forward(at, screen);
    else this.make(from, at, screen);
  }

  /** All changes since a whole state brought into it, and shown at once: most objects change many times. */
  private make(from: number, at: number, screen: Screen): void {
    const state: State = {};
    for (const [topic, objects] of Object.entries(this.pieces[from]?.state ?? {})) state[topic] = { ...objects };
    const own = new Set<object>();
    this.index = from;
    this.within = 0;
    this.wholeAt = Number.NEGATIVE_INFINITY;
    const into: Screen = {
      whole: () => undefined,
      change: ([, topic, key, value]) => {
        const objects = (state[topic] ??= {});
        const before = objects[key];
        if (value === null) delete objects[key];
        else if (topic !== "vehicles" || !before) objects[key] = value;
        else if (own.has(before)) Object.assign(before, value);
        else own.add((objects[key] = { ...before, ...value }));
      },
    };
    this.forward(at, into);
    screen.whole(state);
  }

  /** Go on to a moment that is not before the present one. */
  forward(at: number, screen: Screen): void {
    this.now = at;
    for (let piece = this.pieces[this.index]; piece; piece = this.pieces[this.index]) {
      if (piece.state) {
        if (piece.begin > at && this.index > 0) return;
        // It is what the changes before it led to, unless some were lost: showing it costs more than it is worth.
        if (this.index === 0 || piece.begin - this.wholeAt >= ANEW) {
          this.wholeAt = piece.begin;
          screen.whole(piece.state);
        }
      } else {
        const changes = piece.changes ?? [];
        for (; this.within < changes.length; this.within++) {
          const change = changes[this.within] as Change;
          if (change[0] > at) return;
          screen.change(change);
        }
      }
      this.index++;
      this.within = 0;
    }
  }

  /** Let go of what lies furthest back if there is very much of it, up to a whole state; returns from when on there is something. */
  trim(): number {
    while (this.count > MOST) {
      const next = this.pieces.findIndex((piece, i) => i > 0 && piece.state);
      if (next < 0 || next >= this.index) break;
      for (const piece of this.pieces.splice(0, next)) this.count -= piece.changes?.length ?? 0;
      this.index -= next;
    }
    return this.begin;
  }
}
