import { describe, expect, test } from "vitest";
import { lastTakenBack, phasesOf } from "../src/phases";
import type { Happening } from "../src/types";

const at = (second: number): string => new Date(Date.UTC(2026, 0, 1, 8, 0, second)).toISOString();
const event = (name: string, second: number) => ({ event: name, ts: at(second) }) as Happening;
const ALL = [
  event("VehicleAssigned", 2),
  event("VehicleAssigned", 5),
  event("VehicleAcquireStarted", 20),
  event("VehicleAcquireCompleted", 25),
  event("VehicleDepositStarted", 50),
  event("VehicleDepositCompleted", 56),
];

describe("the phases of a job", () => {
  test("lie between its events; the last assignment ends the queue", () => {
    expect(phasesOf(at(0), null, ALL)).toEqual([
      { name: "queued", took: 5 },
      { name: "fetching", took: 15 },
      { name: "acquiring", took: 5 },
      { name: "carrying", took: 25 },
      { name: "depositing", took: 6 },
    ]);
  });

  test("begin anew with the queue where the vehicle was taken away, and end it at the next assignment", () => {
    const back = [...ALL.slice(0, 3), event("VehicleUnassigned", 22)];
    expect(phasesOf(at(0), Date.parse(at(40)), back)).toEqual([{ name: "queued", took: 40 }]);
    expect(phasesOf(at(0), Date.parse(at(40)), [...back, event("VehicleAssigned", 30)])).toEqual([
      { name: "queued", took: 30 },
      { name: "fetching", took: 10 },
    ]);
  });

  test("are not begun anew by the end of the job, at which it loses its vehicle too", () => {
    const whole = [...ALL.slice(0, 2), event("VehicleUnassigned", 6), event("VehicleAssigned", 8), ...ALL.slice(2), event("VehicleUnassigned", 56)];
    expect(phasesOf(at(0), null, whole).map(({ took }) => took)).toEqual([8, 12, 5, 25, 6]);
    expect(lastTakenBack(whole, true)).toBe(2);
    expect(lastTakenBack([...ALL, event("VehicleUnassigned", 56)], true)).toBe(-1);
  });

  test("last until now where one is under way, and end with the job", () => {
    expect(phasesOf(at(0), Date.parse(at(12)), [])).toEqual([{ name: "queued", took: 12 }]);
    expect(phasesOf(at(0), Date.parse(at(30)), ALL.slice(0, 4)).at(-1)).toEqual({ name: "carrying", took: 5 });
    expect(phasesOf(at(0), null, ALL.slice(0, 2))).toEqual([{ name: "queued", took: 5 }]);
    expect(phasesOf(at(0), null, [])).toEqual([]);
  });
});
