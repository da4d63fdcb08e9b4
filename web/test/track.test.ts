import { describe, expect, test } from "vitest";
import { Glide } from "../src/glide";
import { clustersOf } from "../src/places";
import { Track } from "../src/track";
import type { Layout } from "../src/types";

const edge = (start: string, end: string, length = 1000, curve = false) => ({
  start,
  end,
  length,
  speed: 100,
  sensor: 0,
  curve,
});
const point = (barcode: string, x: number, y: number) => ({ barcode, x, y, park: false });

/** A straight of three metres, a quarter circle, and a branch going straight on. */
const LAYOUT: Layout = {
  name: "test",
  points: [
    point("1", 0, 0),
    point("2", 1000, 0),
    point("3", 2000, 0),
    point("4", 3000, 0),
    point("5", 4000, 1000),
    point("6", 4000, 0),
    point("7", 5000, 0),
  ],
  edges: [edge("1", "2"), edge("2", "3"), edge("3", "4"), edge("4", "5", 1571, true), edge("4", "6"), edge("6", "7")],
  stations: [
    { id: "ETCH-P1", kind: "port", barcode: "1", display: "", buffer: null },
    { id: "ETCH-P2", kind: "port", barcode: "2", display: "", buffer: null },
    { id: "BUF-L1", kind: "sbfl", barcode: "2", display: "", buffer: null },
  ],
  zones: [],
  vehicles: [],
  links: [],
  doors: [],
  buffers: [],
  chargers: [],
  drives: [],
};
const track = new Track(LAYOUT);

describe("the track", () => {
  test("draws a curve that leaves straight track in its direction", () => {
    const way = track.way("4", "5");
    expect(way).toBeDefined();
    const { angle } = track.along(way!, 1);
    expect(Math.abs(angle)).toBeLessThan(0.2);
    const middle = track.along(way!, 1571 / 2);
    expect(middle.x).toBeGreaterThan(3500);
  });

  test("finds the way over the fewest edges, or none", () => {
    expect(track.path("1", "5")).toEqual(["1", "2", "3", "4", "5"]);
    expect(track.path("5", "1")).toBeUndefined();
    expect(track.path("1", "7", 3)).toBeUndefined();
  });

  test("puts side buffers on their side, and ports of one machine together", () => {
    const clusters = clustersOf(LAYOUT, track);
    expect(clusters.map((cluster) => cluster.name)).toEqual(["ETCH", "BUF"]);
    expect(clusters[0]?.marks).toHaveLength(2);
    expect(clusters[1]?.marks[0]?.y).toBeLessThan(0);
    expect(clusters[0]?.marks.every((mark) => mark.y > 0)).toBe(true);
  });
});

describe("groups whose stations begin alike", () => {
  test("are told apart by their first and last, and one that is alone keeps the common name", () => {
    const buffer = (id: string, barcode: string) => ({ id, kind: "sbfl", barcode, display: "", buffer: null });
    const stations = [buffer("SBA-L10", "1"), buffer("SBA-L9", "2"), buffer("SBA-L2", "7"), buffer("SBB-L1", "4")];
    const names = clustersOf({ ...LAYOUT, stations }, track).map(({ name }) => name);
    expect(names).toEqual(["SBA-L9…L10", "SBA-L2", "SBB"]);
  });
});

describe("a drawn vehicle", () => {
  const report = (barcode: string, granted: string[], moving = true, dist = 0) => ({ barcode, dist, granted, moving });

  test("stands where it first reports", () => {
    const glide = new Glide(track);
    glide.report(report("2", [], false, 300), 0);
    expect(glide.drive(0.1).middle()?.x).toBeCloseTo(1300, 0);
  });

  test("moves between reports without going back or beyond its grant", () => {
    const glide = new Glide(track, 2000);
    glide.report(report("1", ["2", "3"]), 0);
    glide.report(report("2", ["3"]), 1);
    let last = 0;
    for (let now = 1; now < 6; now += 0.03) {
      const x = glide.drive(now).middle()?.x ?? -1;
      expect(x).toBeGreaterThanOrEqual(last - 0.001);
      expect(x).toBeLessThanOrEqual(2000.001);
      last = x;
    }
    expect(last).toBeGreaterThan(1500);
  });

  test("follows reports that skip barcodes along the track", () => {
    const glide = new Glide(track, 2000);
    glide.report(report("1", ["2"]), 0);
    glide.drive(0.1);
    glide.report(report("3", ["4", "6"]), 1);
    const spot = glide.drive(1.03).middle();
    expect(spot?.y).toBe(0);
    expect(spot?.x).toBeLessThan(1000);
  });

  test("jumps where no track leads", () => {
    const glide = new Glide(track);
    glide.report(report("5", [], false), 0);
    glide.drive(0.1);
    glide.report(report("1", ["2"], false), 1);
    expect(glide.drive(1.03).middle()?.x).toBeCloseTo(0, 0);
  });

  test("is nowhere before its place is known", () => {
    const glide = new Glide(track);
    glide.report({ barcode: null, dist: null, granted: [], moving: false }, 0);
    expect(glide.drive(1).middle()).toBeNull();
  });
});
