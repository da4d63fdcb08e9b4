import { describe, expect, test } from "vitest";
import { wrongs } from "../src/alarms";
import { Heat } from "../src/heat";
import { Sayings } from "../src/sayings";
import type { Controller, Vehicle } from "../src/types";

const vehicle = (id: string, more: Partial<Vehicle> = {}): Vehicle =>
  ({
    id,
    activity: "idle",
    link: { up: true, since: "2026-01-01T00:00:00Z", reason: "" },
    oper: "ready",
    barcode: "1",
    hold: null,
    lockout: null,
    ...more,
  }) as Vehicle;

describe("what is wrong", () => {
  const controller = { plant: "fab", trouble: "", emergencies: [], circles: [] } as unknown as Controller;
  const of = (...vehicles: Vehicle[]) => wrongs({ controller, vehicles, devices: [], drives: [] });

  test("has alarms before what people hold back, each with its cause and remedy", () => {
    const held = vehicle("V1", { hold: { reason: "held by Kim", remedy: "release it", since: "2026-01-01T00:00:00Z" } });
    const alarm = vehicle("V2", { oper: "alarm", code: 0x8001, code_name: "obstacle" });
    const list = of(held, alarm, vehicle("V3"));
    expect(list.map(({ source, grave }) => [source, grave])).toEqual([
      ["V2", true],
      ["V1", false],
    ]);
    expect(list[0]?.cause).toBe("0x8001 obstacle");
    expect(list[1]?.remedy).toBe("release it");
  });

  test("has circles of hoists", () => {
    const found = wrongs({ controller: { ...controller, circles: ["V1, V2 wait for each other"] }, vehicles: [], devices: [], drives: [] });
    expect(found.map(({ cause }) => cause)).toEqual(["V1, V2 wait for each other"]);
  });

  test("has a vehicle that is not heard, but none that was taken off the rail", () => {
    const link = { up: false, since: "2026-01-01T00:00:00Z", reason: "timed out" } as Vehicle["link"];
    expect(of(vehicle("V1", { link })).map(({ cause }) => cause)).toEqual(["it is not connected: timed out"]);
    expect(of(vehicle("V1", { link, activity: "off_rail" }))).toEqual([]);
  });
});

describe("heat", () => {
  test("counts seconds waited where they were waited, and vehicles where they came", () => {
    const heat = new Heat();
    heat.take(vehicle("V1", { activity: "waiting" }), 0);
    heat.take(vehicle("V1", { activity: "waiting" }), 3);
    heat.take(vehicle("V1", { activity: "moving", barcode: "2" }), 4);
    heat.take(vehicle("V1", { activity: "moving", barcode: "2" }), 9);
    expect(heat.most("waiting")).toBe(4);
    expect(heat.shares("traffic")).toEqual([["2", 1]]);
  });

  test("of a period is as the server has counted it", () => {
    const heat = Heat.of({ waiting: { "1": 4, "2": 1 }, traffic: { "2": 7 } });
    expect(heat.most("waiting")).toBe(4);
    expect(heat.shares("waiting")).toEqual([["1", 1], ["2", 0.5]]);
    expect(heat.shares("traffic")).toEqual([["2", 1]]);
  });

  test("does not count a gap in the reports as a wait", () => {
    const heat = new Heat();
    heat.take(vehicle("V1", { activity: "waiting" }), 0);
    heat.take(vehicle("V1"), 600);
    expect(heat.most("waiting")).toBe(5);
  });
});

describe("sayings", () => {
  const sayings = new Sayings(
    { waits: "{0} waits at {1} for {2}", held: "{0} held by {1}", silent: "{0}, which is silent ({1})" },
    { waits: "{1}의 {0}: {2} 대기", held: "{1}이(가) 점유한 {0}", silent: "응답 없는 {0} ({1})" },
  );

  test("are translated with what is filled in, and sentences within them too", () => {
    expect(sayings.translate("V1 waits at 1001 for 1002 held by V2")).toBe("1001의 V1: V2이(가) 점유한 1002 대기");
  });

  test("are told apart where one says a reason and what would help", () => {
    expect(sayings.translate("nobody knows; V3, which is silent (off)")).toBe("nobody knows; 응답 없는 V3 (off)");
  });

  test("come out as they are but for those that have other words on the page", () => {
    const from = { recover: "POST /api/v1/vehicles/{0}/recover", alarm: "{0} still has an alarm" };
    const page = new Sayings(from, { ...from, recover: "press Recover at {0}" }, ["recover"]);
    expect(page.translate("V1 still has an alarm; POST /api/v1/vehicles/V1/recover")).toBe("V1 still has an alarm; press Recover at V1");
    expect(page.translate("V1 still has an alarm")).toBe("V1 still has an alarm");
  });

  test("stay as they are where no pattern fits", () => {
    expect(sayings.translate("nothing of this is known")).toBe("nothing of this is known");
    expect(sayings.translate("")).toBe("");
  });
});
