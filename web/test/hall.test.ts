import { describe, expect, test } from "vitest";
import { doorMarks } from "../src/doors";
import { joins, worldOf } from "../src/ends";
import { Glide } from "../src/glide";
import { Labels } from "../src/paint/labels";
import type { Now, Scene } from "../src/paint/ink";
import { paintPlant } from "../src/paint/plant";
import { Signs } from "../src/paint/vehicles";
import { clustersOf } from "../src/places";
import { colourOfDevice, DEVICE_LOOKS, lookOf, lookOfDevice, lookOfDrive, signOfDevice } from "../src/shows";
import { Track } from "../src/track";
import type { Device, Drive, Layout, Vehicle } from "../src/types";
import { type Box, View } from "../src/view";

const edge = (start: string, end: string) => ({ start, end, length: 1000, speed: 100, sensor: 0, curve: false });
const point = (barcode: string, x: number, y = 0) => ({ barcode, x, y, park: false });
const station = (id: string, kind: string, barcode: string) => ({ id, kind, barcode, display: "", buffer: null });
const both = (a: string, b: string) => [edge(a, b), edge(b, a)];

/** A lane driven both ways with a door in it, a rail elsewhere. */
const HALL: Layout = {
  name: "hall",
  points: [...["t1", "t2", "t3", "t4"].map((tag, i) => point(tag, i * 1000)), point("r1", 0, 9000), point("r2", 1000, 9000)],
  edges: [...both("t1", "t2"), ...both("t2", "t3"), ...both("t3", "t4"), edge("r1", "r2")],
  stations: [station("AB1", "agv_buffer", "t4"), station("P1", "port", "r1"), station("L1", "sbfl", "r2")],
  zones: [],
  vehicles: [
    { id: "AGV1", kind: "agv", link: "hall", length: 1000, max_speed: 500, curve_speed: 500 },
    { id: "V1", kind: "hoist", link: null, length: 1000, max_speed: 3000, curve_speed: 1000 },
  ],
  links: [],
  doors: [{ id: "DOOR1", link: "hall", number: 30, passages: [["t3", "t2"]], normally_open: false }],
  buffers: [],
  chargers: [{ id: "C1", barcode: "t1", alias: null }],
  drives: [],
};
const track = new Track(HALL);
const device = (more: Partial<Device>): Device =>
  ({ id: "DOOR1", kind: "door", fresh: true, reason: "", state: "closed", alarm: "", vehicles: [], ...more }) as Device;
const vehicle = (more: Partial<Vehicle>): Vehicle =>
  ({ id: "AGV1", activity: "idle", oper: null, link: { up: true }, covered: [], granted: [], barcode: null, ...more }) as Vehicle;
const drive = (more: Partial<Drive>): Drive =>
  ({ id: "AX1", online: true, mode: "monitoring", reason: "", meaning: "normal", ...more }) as Drive;

describe("a hall", () => {
  test("knows which track is driven both ways, and which lies on the floor", () => {
    expect(track.twoWay(edge("t1", "t2"))).toBe(true);
    expect(track.twoWay(edge("r1", "r2"))).toBe(false);
    expect([...track.floor].sort()).toEqual(["t1", "t2", "t3", "t4"]);
  });

  test("has its door in the middle of the passage, whichever way that is named", () => {
    expect(doorMarks(HALL, track)).toMatchObject([{ id: "DOOR1", x: 1500, y: 0, named: true }]);
  });

  test("has a mark for its charger beside the tag", () => {
    const charger = clustersOf(HALL, track).flatMap(({ marks }) => marks).find(({ id }) => id === "C1");
    expect(charger?.kind).toBe("charger");
    expect(Math.abs(charger?.y ?? 0)).toBeGreaterThan(500);
  });

  test("joins ends of one kind only", () => {
    expect(worldOf(HALL, "AB1")).toBe("agv");
    expect(worldOf(HALL, "V1")).toBe("hoist");
    expect(joins(HALL, "P1", "L1")).toBe(true);
    expect(joins(HALL, "AGV1", "AB1")).toBe(true);
    expect(joins(HALL, "P1", "AB1")).toBe(false);
    expect(joins(HALL, "", "AB1")).toBe(true);
  });
});

describe("a door", () => {
  test("looks like its state only while it is heard", () => {
    expect(lookOfDevice(device({}))).toBe("closed");
    expect(lookOfDevice(device({ fresh: false }))).toBe("silent");
    expect(lookOfDevice(device({ state: "half open" }))).toBe("unknown");
    expect(lookOfDevice(undefined)).toBe("silent");
  });

  test("keeps its form under an alarm, and gets its sign and colour", () => {
    const stuck = device({ alarm: "does not open" });
    expect([lookOfDevice(stuck), signOfDevice(stuck, "closed")]).toEqual(["closed", "!"]);
    expect(colourOfDevice(stuck, "closed")).toBe(DEVICE_LOOKS.error);
    expect(signOfDevice(device({}), "closed")).toBe("");
  });
});

describe("looks", () => {
  test("a charger says nothing itself: somebody charges there, or nobody", () => {
    expect(lookOfDevice(device({ kind: "charger", state: null, fresh: false }))).toBe("free");
    expect(lookOfDevice(device({ kind: "charger", state: null, vehicles: ["AGV1"] }))).toBe("charging");
  });

  test("a drive in error or offline is bad, one not heard yet is waited for", () => {
    expect(lookOfDrive(drive({}))).toEqual({ word: "monitoring", tone: "good" });
    expect(lookOfDrive(drive({ mode: "error" }))).toEqual({ word: "error", tone: "bad" });
    expect(lookOfDrive(drive({ online: false }))).toEqual({ word: "offline", tone: "bad" });
    expect(lookOfDrive(drive({ online: null }))).toEqual({ word: "not_heard", tone: "wait" });
  });

  test("an AGV that charges has a look of its own", () => {
    expect(lookOf(vehicle({ activity: "charging" }))).toBe("charging");
  });
});

describe("names", () => {
  test("take the first place where nothing is, or none", () => {
    const labels = new Labels();
    labels.block({ x0: -10, y0: -10, x1: 10, y1: 10 });
    const places = [
      { x: 0, y: 0 },
      { x: 50, y: 0 },
    ];
    expect(labels.take(places, 20)).toBe(1);
    expect(labels.take(places, 20)).toBe(-1);
  });
});

describe("names of vehicles", () => {
  const view = Object.assign(new View(), { scale: 0.03, x: 200, y: 150, width: 400, height: 300 });
  const signs = new Signs();
  /** What is said where, and where lines end. */
  const paint = (look: "idle" | "held", still: (box: Box) => boolean, by = signs) => {
    const said: { words: string; x: number; y: number }[] = [];
    const lines: [number, number][] = [];
    const ctx = {
      measureText: () => ({ width: 30 }),
      fillText: (words: string, x: number, y: number) => said.push({ words, x, y }),
      lineTo: (x: number, y: number) => lines.push([x, y]),
      beginPath() {},
      moveTo() {},
      stroke() {},
      roundRect() {},
      fill() {},
    };
    const body = { vehicle: { id: "V1" } as Vehicle, look, agv: false, spot: { x: 0, y: 0, angle: 0 }, length: 900 };
    by.paint(ctx as unknown as CanvasRenderingContext2D, view, [body], () => false, still, { x0: 0, y0: 0, x1: 400, y1: 300 });
    return { said, lines };
  };
  /** A station's name lies over all that is near the vehicle. */
  const around = { x0: 120, x1: 280, y0: 100, y1: 200 };
  const beside = (box: Box): boolean => box.x1 < around.x0 || box.x0 > around.x1 || box.y1 < around.y0 || box.y0 > around.y1;

  test("leave the names of stations free: one of a vehicle in trouble is set farther off, with a line to it", () => {
    expect(paint("idle", () => true).said.map(({ words }) => words)).toEqual(["V1"]);
    expect(paint("idle", beside).said).toEqual([]);
    const { said, lines } = paint("held", beside);
    expect(said.map(({ words }) => words)).toEqual(["V1 ‖"]);
    const { x, y } = said[0] as { x: number; y: number };
    expect(beside({ x0: x - 19, x1: x + 19, y0: y - 10, y1: y + 3 })).toBe(true);
    expect([x > 19 && x < 381, y > 10 && y < 297]).toEqual([true, true]);
    expect(lines.length).toBeGreaterThan(0);
    expect(lines.at(-1)?.[0]).toBe(x);
  });

  test("stay where they are while that is free, and need no line beside the vehicle", () => {
    const [first, second] = [paint("held", beside), paint("held", beside)];
    expect(second.said).toEqual(first.said);
    const near = paint("held", () => true, new Signs());
    const far = Math.hypot((near.said[0]?.x ?? 0) - 200, (near.said[0]?.y ?? 0) - 150);
    expect(far).toBeLessThan(60);
  });

  test("of vehicles in trouble cover a station's where there is no room at all: it is the vehicle that needs somebody", () => {
    expect(paint("held", () => false, new Signs()).said.map(({ words }) => words)).toEqual(["V1 ‖"]);
  });
});

describe("the name of a station", () => {
  const clusters = clustersOf(HALL, track);
  const scene: Scene = { layout: HALL, track, clusters, marks: clusters.flatMap(({ marks }) => marks), doors: [] };
  const view = Object.assign(new View(), { scale: 0.03, x: 300, y: 200, width: 800, height: 700 });
  const now: Now = { station: () => undefined, device: () => undefined, look: () => "silent", picked: null, zones: false };
  const named = (trouble: Box[]): { x: number; y: number } => {
    const said = new Map<string, { x: number; y: number }>();
    const known: Record<string, unknown> = { measureText: () => ({ width: 30 }), fillText: (words: string, x: number, y: number) => said.set(words, { x, y }) };
    const ctx = new Proxy({}, { get: (_, name: string) => known[name] ?? (() => undefined), set: () => true });
    paintPlant(ctx as CanvasRenderingContext2D, view, scene, now, trouble);
    return said.get("AB1") as { x: number; y: number };
  };

  test("keeps clear of a vehicle that stands in trouble, and is not lost", () => {
    const usual = named([]);
    const over = { x0: usual.x - 20, x1: usual.x + 20, y0: usual.y - 14, y1: usual.y + 6 };
    const { x, y } = named([over]);
    expect(x + 17 <= over.x0 || x - 17 >= over.x1 || y + 3 <= over.y0 || y - 10 >= over.y1).toBe(true);
    expect(Math.hypot(x - usual.x, y - usual.y)).toBeLessThan(120);
  });

  test("stays where a vehicle covers all around it", () => {
    expect(named([{ x0: 0, x1: 800, y0: 0, y1: 700 }])).toEqual(named([]));
  });
});

describe("a drawn AGV", () => {
  test("comes back on the track that it went", () => {
    const glide = new Glide(track, 500);
    const report = (barcode: string, granted: string[], now: number, moving = true): void =>
      glide.report({ barcode, dist: 0, granted, moving }, now);
    const at = (now: number): number => {
      for (let t = now - 3.9; t < now; t += 0.05) glide.drive(t);
      return glide.drive(now).middle()?.x ?? -1;
    };
    report("t3", ["t4"], 0);
    report("t4", [], 2, false);
    expect(at(8)).toBeCloseTo(3000, 0);
    report("t4", ["t3", "t2", "t1"], 10);
    report("t3", ["t2", "t1"], 12);
    const there = at(14);
    expect(there).toBeLessThanOrEqual(2000.1);
    expect(there).toBeGreaterThanOrEqual(1000);
    report("t2", ["t1"], 14);
    report("t1", [], 16, false);
    expect(at(20)).toBeCloseTo(0, 0);
  });
});
