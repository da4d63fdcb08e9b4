import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { page as en } from "../../app/texts/en.json";
import { type Around, againstAgv, againstCommand, againstDevice, againstDrive, againstHandling, againstMove, againstPin, againstRecovery, againstVerdict } from "../src/against";
import type { Closure, Device, Drive, Vehicle } from "../src/types";

const AROUND: Around = {
  controller: { emergencies: [], waiting_for: [], state: "auto", reason: "" },
  closures: [],
  layout: { stations: [{ id: "P1", kind: "port", barcode: "1001", display: "", buffer: null }], chargers: [{ id: "C1", barcode: "2001", alias: null }], vehicles: [], edges: [] },
  vehicles: [],
};
const FIRE: Around = { ...AROUND, controller: { emergencies: ["fire"], waiting_for: [], state: "auto", reason: "" } };
const LOCKOUT = { owner: "lee", reason: "a wheel", since: "", releases: [] };
const vehicle = (more: Partial<Record<string, unknown>> = {}): Vehicle =>
  ({
    id: "V001",
    activity: "idle",
    service: "in_service",
    link: { up: true },
    mode: "auto",
    oper: "idle",
    barcode: "1001",
    loaded: false,
    job: null,
    hold: null,
    lockout: null,
    granted: [],
    covered: [more.barcode ?? "1001"],
    ...more,
  }) as unknown as Vehicle;
const word = (against: readonly [string, ...unknown[]] | null): string => against?.[0] ?? "";

describe("a hoist's command", () => {
  const of = (command: string, more: Partial<Record<string, unknown>> = {}, around = AROUND) => word(againstCommand(vehicle(more), command, around));

  test("that needs MANT is not offered in AUTO, and a stop by host not in MANT", () => {
    expect(of("servo_on")).toBe("against_not_mant");
    expect(of("servo_on", { mode: "mant" })).toBe("");
    expect(of("stop_by_host")).toBe("");
    expect(of("stop_by_host", { mode: "mant" })).toBe("against_mant");
    expect(of("display", { mode: "mant" })).toBe("against_mant");
  });

  test("that reads or stops goes through lockout, emergency and recovery; others do not", () => {
    for (const [more, around, why] of [
      [{ lockout: LOCKOUT }, AROUND, "against_lockout"],
      [{}, FIRE, "against_emergency"],
      [{ activity: "recovering" }, AROUND, "against_recovery"],
    ] as const) {
      expect(of("stop", more, around)).toBe("");
      expect(of("status", more, around)).toBe("");
      expect(of("auto", { mode: "mant", ...more }, around)).toBe(why);
    }
    expect(of("display", { lockout: LOCKOUT })).toBe("against_lockout");
    expect(of("status", { link: { up: false } })).toBe("against_link");
  });

  test("is not offered where people are at work, once the place is closed", () => {
    const closure = { purpose: "work", state: "closed", kind: "stretch", barcodes: ["1001"], place: "1001", owner: "kim" } as Closure;
    const around = { ...AROUND, closures: [closure] };
    expect(of("servo_off", { mode: "mant" }, around)).toBe("against_work");
    expect(of("servo_off", { mode: "mant" }, { ...AROUND, closures: [{ ...closure, state: "draining" }] })).toBe("");
    expect(of("servo_off", { mode: "mant", barcode: "1009" }, around)).toBe("");
  });
});

test("a vehicle is moved only where nothing the page knows keeps it", () => {
  const of = (more: object, around = AROUND) => word(againstMove(vehicle(more), around));
  expect(of({})).toBe("");
  expect(of({ hold: {} })).toBe("against_hold");
  expect(of({ service: "out_of_service" })).toBe("against_service");
  expect(of({ job: "J1" })).toBe("against_job");
  expect(of({ mode: "mant" })).toBe("against_not_auto");
  expect(of({ oper: "alarm" })).toBe("against_alarm");
  expect(of({ activity: "settling" })).toBe("against_settling");
  expect(of({ activity: "off_rail" })).toBe("against_off_rail");
});

test("a vehicle is not moved while one is missing that may stand in its way, and is where that one cannot be", () => {
  const edges = [["1000", "1001"], ["1001", "1002"], ["2001", "2002"]].map(([start, end]) => ({ start, end }));
  const kinds = [["V001", "hoist"], ["V002", "hoist"], ["AGV1", "agv"]].map(([id, kind]) => ({ id, kind }));
  const of = (id: string, barcode: string | null, mode: string | null = null) => {
    const controller = { emergencies: [], waiting_for: [id], state: "auto", reason: "" };
    const layout = { ...AROUND.layout, edges, vehicles: kinds } as unknown as Around["layout"];
    return againstMove(vehicle(), { ...AROUND, controller, layout, vehicles: [{ id, barcode, mode }] });
  };
  expect(of("V002", "1002")).toEqual(["against_roll_call", "V002"]);
  expect(of("V002", "2002")).toBeNull();
  expect(of("V002", null)).toEqual(["against_roll_call", "V002"]);
  expect(of("AGV1", null)).toBeNull();
  expect(of("V002", "1002", "auto")).toBeNull();
});

test("a carrier is picked up by an empty vehicle and put down by a loaded one, at the station where it stands", () => {
  expect(againstHandling(vehicle(), "P1", true, AROUND)).toBeNull();
  expect(word(againstHandling(vehicle(), "P1", false, AROUND))).toBe("against_empty");
  expect(word(againstHandling(vehicle({ loaded: true }), "P1", true, AROUND))).toBe("against_loaded");
  expect(againstHandling(vehicle({ barcode: "1009" }), "P1", true, AROUND)).toEqual(["against_elsewhere", "1001", "1009"]);
});

test("an AGV is asked in the mode and state that each command wants", () => {
  const of = (command: string, more: object = {}) => word(againstAgv(vehicle(more), command, AROUND));
  expect(of("alarm_clear")).toBe("against_no_error");
  expect(of("alarm_clear", { oper: "alarm" })).toBe("");
  expect(of("agv_mark_stop")).toBe("against_stands");
  expect(of("agv_mark_stop", { oper: "run" })).toBe("");
  expect(of("agv_move_manual")).toBe("against_agv_auto");
  expect(of("agv_move_manual", { mode: "mant" })).toBe("");
  expect(of("agv_move_auto", { mode: "mant" })).toBe("against_agv_manual");
  expect(of("agv_move_alias", { oper: "run" })).toBe("against_runs");
  expect(of("agv_lift up", { job: "J1" })).toBe("against_job");
  expect(of("agv_lift stop", { job: "J1", lockout: LOCKOUT })).toBe("");
  expect(of("agv_charge on")).toBe("against_no_charger");
  expect(of("agv_charge on", { barcode: "2001" })).toBe("");
  expect(of("agv_charge off", { oper: "run" })).toBe("");
});

test("a verdict fits whether the vehicle reports", () => {
  expect(word(againstVerdict(vehicle(), "go_on"))).toBe("against_nothing_held");
  expect(againstVerdict(vehicle({ hold: {} }), "go_on")).toBeNull();
  expect(word(againstVerdict(vehicle({ hold: {}, oper: "alarm" }), "go_on"))).toBe("against_alarm");
  expect(word(againstVerdict(vehicle(), "off_rail"))).toBe("against_linked");
  expect(againstVerdict(vehicle({ link: { up: false } }), "stands_at")).toBeNull();
  expect(word(againstRecovery(vehicle(), FIRE))).toBe("against_emergency");
});

test("a door is not closed on somebody, nor against who keeps it; a buffer not from under a vehicle", () => {
  const device = (more: object): Device => ({ fresh: true, lockout: null, pin: null, lock: null, vehicles: [], ...more }) as unknown as Device;
  expect(againstDevice(device({}), "close")).toBeNull();
  expect(word(againstDevice(device({ fresh: false }), "close"))).toBe("against_silent");
  expect(againstDevice(device({ fresh: false }), "open")).toBeNull();
  expect(againstDevice(device({ vehicles: ["AGV1"] }), "close")).toEqual(["against_engaged", "AGV1"]);
  expect(word(againstDevice(device({ pin: { position: "open", owner: "kim" } }), "close"))).toBe("against_pin");
  expect(word(againstDevice(device({ lock: { owner: "AGV1", person: false } }), "unlock"))).toBe("against_locked_for");
  expect(againstDevice(device({ lock: { owner: "kim", person: true } }), "unlock")).toBeNull();
  expect(word(againstDevice(device({ lockout: LOCKOUT }), "open"))).toBe("against_lockout");
  expect(word(againstPin(device({ vehicles: ["AGV1"] }), "closed"))).toBe("against_engaged");
});

test("a drive is jogged online and in jog, without error; a stop goes to one that does not answer", () => {
  const drive = (more: object): Drive => ({ online: true, reason: "", mode: "jog", lockout: null, operation: null, moving: false, line: "AXES", ...more }) as unknown as Drive;
  expect(againstDrive(drive({}), "jog", AROUND)).toBeNull();
  expect(word(againstDrive(drive({ mode: "monitoring" }), "jog", AROUND))).toBe("against_not_jog");
  expect(word(againstDrive(drive({ mode: "error" }), "move", AROUND))).toBe("against_drive_error");
  expect(word(againstDrive(drive({ operation: "7" }), "change", AROUND))).toBe("against_operation");
  expect(againstDrive(drive({ operation: "7" }), "read", AROUND)).toBeNull();
  expect(word(againstDrive(drive({ moving: true }), "write", AROUND))).toBe("against_drive_runs");
  expect(word(againstDrive(drive({ online: false, reason: "timed out" }), "read", AROUND))).toBe("against_offline");
  expect(againstDrive(drive({ online: false, reason: "timed out" }), "harmless", AROUND)).toBeNull();
  expect(word(againstDrive(drive({ online: null, reason: "refused" }), "harmless", AROUND))).toBe("against_line");
  expect(word(againstDrive(drive({}), "jog", FIRE))).toBe("against_emergency");
});

test("each reason has its words", () => {
  const source = readFileSync(new URL("../src/against.ts", import.meta.url), "utf-8");
  const words = [...source.matchAll(/"(against_\w+)"/g)].map(([, name]) => name as string);
  expect(words.length).toBeGreaterThan(20);
  expect(words.filter((name) => !Object.hasOwn(en, name))).toEqual([]);
});
