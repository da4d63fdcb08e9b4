import { describe, expect, test } from "vitest";
import { groupsOf, releasable } from "../src/groups";
import type { Alarm, Vehicle } from "../src/types";

const alarm = (id: number, source: string, more: Partial<Alarm> = {}): Alarm =>
  ({ id, kind: "link", source, code: "silent", cause: `not connected: no answer of ${source}`, remedy: "look", ...more }) as Alarm;

describe("alarms of one cause", () => {
  test("are one group in the place of the newest, told with a dash for what is each one's own", () => {
    const found = groupsOf([alarm(3, "V3"), alarm(2, "D1", { kind: "drive", code: "error 03" }), alarm(1, "V1")]);
    expect(found.map(({ alarms }) => alarms.map(({ id }) => id))).toEqual([[3, 1], [2]]);
    expect(found[0]?.cause).toBe("not connected: no answer of –");
    expect(found[0]?.remedy).toBe("look");
  });

  test("keep their words and lose a remedy that is not that of all", () => {
    const [group] = groupsOf([alarm(2, "V2", { cause: "off", remedy: "one" }), alarm(1, "V1", { cause: "off", remedy: "other" })]);
    expect(group).toMatchObject({ cause: "off", remedy: "" });
  });

  test("of holds are told apart by cause, since all have one code", () => {
    const hold = { kind: "hold", code: "held" };
    const far = (id: number, source: string) => alarm(id, source, { ...hold, cause: `${source} reports 10${id}, which it cannot have reached` });
    const found = groupsOf([far(3, "V3"), alarm(2, "V2", { ...hold, cause: "the pick-up failed" }), far(1, "V1")]);
    expect(found.map(({ cause }) => cause)).toEqual(["– reports – which it cannot have reached", "the pick-up failed"]);
  });
});

test("a hold is released together with others only where its vehicle is connected and without an alarm", () => {
  const held = { hold: { reason: "", remedy: "", since: "" }, oper: "ready", activity: "held", link: { up: true } } as Vehicle;
  expect(releasable(held)).toBe(true);
  expect(releasable({ ...held, oper: "alarm" })).toBe(false);
  expect(releasable({ ...held, link: { ...held.link, up: false } })).toBe(false);
  expect(releasable({ ...held, hold: null })).toBe(false);
  expect(releasable(undefined)).toBe(false);
});
