import { deflateSync } from "node:zlib";
import { describe, expect, test } from "vitest";
import { kindOf, reachOf } from "../src/past/reach";
import { type Change, type Piece, piecesOf, Reel, type State } from "../src/past/reel";
import { changedOf, ofThen } from "../src/past/then";
import { Trails } from "../src/past/trails";
import { lookOf } from "../src/shows";
import { Track } from "../src/track";
import type { Layout } from "../src/types";

const state = (barcode: string): State => ({ vehicles: { V1: { barcode, activity: "idle" } } });
const drive = (at: number, barcode: string): Change => [at, "vehicles", "V1", { barcode, activity: "moving" }];
const pieces: Piece[] = [
  { id: 1, begin: 100, end: 100, state: state("1") },
  { id: 2, begin: 101, end: 103, changes: [drive(101, "2"), drive(103, "3")] },
  { id: 3, begin: 160, end: 160, state: state("9") },
  { id: 4, begin: 160, end: 162, changes: [drive(161, "4"), [162, "vehicles", "V1", null]] },
];

function reel() {
  const made = new Reel();
  for (const piece of pieces) made.add(piece);
  const seen: string[] = [];
  const screen = {
    whole: (now: State) => void seen.push(`all ${Object.values(now["vehicles"] ?? {}).map((one) => one["barcode"])}`),
    change: ([, , key, value]: Change) => void seen.push(value ? `${value["barcode"]}` : `no ${key}`),
  };
  const at = (moment: number): string[] => {
    seen.length = 0;
    made.seek(moment, screen);
    return [...seen];
  };
  return { made, seen, screen, at };
}

describe("the reel", () => {
  test("shows a moment from the whole state before it, all changes since then at once", () => {
    const { at, made } = reel();
    expect(at(150)).toEqual(["all 3"]);
    expect(at(161.5)).toEqual(["all 4"]);
    expect(at(102)).toEqual(["all 2"]);
    expect(at(165)).toEqual(["all "]);
    expect(at(100)).toEqual(["all 1"]);
    expect([made.holds(99), made.holds(100), made.holds(162), made.holds(163)]).toEqual([false, true, true, false]);
  });

  test("goes on to a later moment where no whole state lies between", () => {
    const { at } = reel();
    expect(at(102)).toEqual(["all 2"]);
    expect(at(103)).toEqual(["3"]);
    expect(at(103)).toEqual([]);
    expect(at(161)).toEqual(["all 4"]);
  });

  test("goes on from there, each change once, and takes a whole state on its way", () => {
    const { at, made, seen, screen } = reel();
    at(102);
    seen.length = 0;
    for (const moment of [102.5, 103, 159, 160, 161, 170]) made.forward(moment, screen);
    expect(seen).toEqual(["3", "all 9", "4", "no V1"]);
  });

  test("passes by a whole state that comes soon after another: it says nothing else", () => {
    const made = new Reel();
    for (const piece of [...pieces.slice(0, 2), { id: 5, begin: 110, end: 110, state: state("3") }, ...pieces.slice(2)]) made.add(piece);
    const seen: string[] = [];
    const screen = { whole: () => void seen.push("all"), change: ([, , , value]: Change) => void seen.push(`${value?.["barcode"]}`) };
    for (const moment of [100, 102, 120, 161]) made.forward(moment, screen);
    expect(seen).toEqual(["all", "2", "3", "all", "4"]);
  });

  test("unpacks an answer of the server: a line that lists the pieces, then the pieces", async () => {
    const bodies = [pieces[0]?.state, pieces[1]?.changes].map((one) => deflateSync(JSON.stringify(one)));
    const items = [
      { id: 1, kind: "state", begin: 100, end: 100, size: bodies[0]?.length },
      { id: 2, kind: "changes", begin: 101, end: 103, size: bodies[1]?.length },
    ];
    const whole = Buffer.concat([Buffer.from(`${JSON.stringify({ items, more: false })}\n`), ...bodies]);
    const found: Piece[] = [];
    for await (const piece of piecesOf(new Uint8Array(whole))) found.push(piece);
    expect(found).toEqual(pieces.slice(0, 2));
  });
});

const edge = (start: string, end: string) => ({ start, end, length: 1000, speed: 100, sensor: 0, curve: false });
const LINE = {
  points: ["1", "2", "3", "4", "5"].map((barcode, i) => ({ barcode, x: i * 1000, y: 0, park: false })),
  edges: [edge("1", "2"), edge("2", "3"), edge("3", "4"), edge("4", "5")],
  stations: [],
  chargers: [],
} as unknown as Layout;

describe("a vehicle's trail", () => {
  const track = new Track(LINE);
  const trails = new Trails();
  trails.whole(100, { vehicles: { V1: { barcode: "1", activity: "moving" } } });
  for (const change of [
    drive(102, "2"),
    [110, "vehicles", "V1", { activity: "waiting" }],
    drive(120, "4"),
    [121, "vehicles", "V1", { activity: "idle" }],
  ] as Change[]) {
    trails.change(change);
  }
  const x = (at: number, back = 0, still = false) => trails.spot(track, "V1", at, back, still)?.x;

  test("lies between two barcodes by the time, and its hull behind it", () => {
    expect([x(100), x(101), x(102)]).toEqual([0, 500, 1000]);
    expect([x(101, 300), x(102, 300), x(100, 300)]).toEqual([200, 700, -300]);
  });

  test("does not creep while it waits, nor drive faster than vehicles can", () => {
    expect([x(111), x(118), x(119.5), x(120)]).toEqual([1000, 1000, 2000, 3000]);
  });

  test("can be asked about in any order, and jumps where nothing is to be seen moving", () => {
    expect([x(125), x(101), x(99), x(121)]).toEqual([3000, 500, undefined, 3000]);
    expect([x(101, 0, true), x(103, 0, true)]).toEqual([0, 1000]);
    expect(trails.spot(track, "V9", 100, 0)).toBeNull();
  });
});

describe("the scrubber", () => {
  const kept = { from: 0, to: 10_000 };

  test("reaches over the same stretch until the moment leaves it", () => {
    const first = reachOf(5000, kept, 600, { from: 0, to: 1 });
    expect(first).toEqual({ from: 4700, to: 5300 });
    expect(reachOf(5299, kept, 600, first)).toBe(first);
    expect(reachOf(5301, kept, 600, first)).toEqual({ from: 5001, to: 5601 });
    expect(reachOf(9990, kept, 600, first)).toEqual({ from: 9400, to: 10_000 });
    expect(reachOf(5000, kept, 3600 * 24, first)).toEqual(kept);
  });

  test("tells alarms, their ends and closures apart", () => {
    const kinds = ["AlarmSet", "TransferAbortCompleted", "AlarmCleared", "PlaceClosed", "VehicleHeld", "TeachingApproved"].map(kindOf);
    expect(kinds).toEqual(["alarm", "alarm", "over", "closure", "halt", "other"]);
  });
});

test("a vehicle of then looks as it did: an alarm, or absent", () => {
  expect(lookOf(ofThen("V1", { activity: "moving", oper: "alarm" }))).toBe("alarm");
  expect(lookOf(ofThen("V1", { activity: "absent" }))).toBe("gone");
  expect(lookOf(ofThen("V1", { activity: "waiting" }))).toBe("waiting");
  const gone = changedOf(ofThen("V1", { activity: "waiting", barcode: "1" }), { activity: "absent" });
  expect([lookOf(gone), gone.barcode]).toEqual(["gone", "1"]);
  expect(lookOf(changedOf(gone, { activity: "waiting" }))).toBe("waiting");
});
