/**
 * What the page says against a request is what the controller says: in the situations of tests/against.json, which the real
 * orders have answered (tests/against.py makes it). The page never refuses what the controller would do; where both name why,
 * they name the same; only what the page cannot know (a sentence after "!") it leaves to the controller.
 */
import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import cases from "../../tests/against.json";
import { type Against, type Around, type Asked, againstAgv, againstCommand, againstDevice, againstDrive, againstHandling, againstMove, againstPin, againstRecovery, againstVerdict } from "../src/against";
import type { Closure, Controller, Device, Drive, Layout, Vehicle } from "../src/types";

type Case = (typeof cases.hoists)[number] | (typeof cases.agvs)[number];
const DEVICES = { door: "door", buffer: "buffer", pin: "door" } as const;

function around(one: Case, layout: unknown): Around {
  const others = Object.entries(one.others).map(([id, other]) => ({ id, ...other }) as unknown as Vehicle);
  const closures = one.closures as unknown as Closure[];
  return { controller: one.controller as unknown as Controller, closures, layout: layout as Layout, vehicles: [...others, one.vehicle as unknown as Vehicle] };
}

function ofVehicle(one: Case, asked: string, layout: unknown): Against {
  const vehicle = one.vehicle as unknown as Vehicle;
  const [what, ...rest] = asked.split(" ");
  const more = rest.join(" ");
  const now = around(one, layout);
  switch (what) {
    case "command":
      return againstCommand(vehicle, more, now);
    case "agv":
      return againstAgv(vehicle, more, now);
    case "move":
      return againstMove(vehicle, now);
    case "pickup":
    case "place":
      return againstHandling(vehicle, more, what === "pickup", now);
    case "recover":
      return againstRecovery(vehicle, now);
    case "verdict":
      return againstVerdict(vehicle, more as "go_on" | "off_rail" | "stands_at");
    default:
      throw new Error(`what is ${asked}?`);
  }
}

/** Where page and controller do not agree, in words; the words that the page has said are noted. */
const told = new Set<string>();
function differs(features: string[], asked: string, against: Against, refused: Record<string, string | undefined>): string[] {
  const [word, theirs] = [against?.[0] ?? "", refused[asked] ?? ""];
  told.add(word);
  if (theirs.startsWith("!") || word === theirs) return [];
  return [`${features.join(" + ") || "nothing"}: ${asked}: the page says ${word || "nothing"}, the controller ${theirs || "does it"}`];
}

describe("the page says against a request what the controller says:", () => {
  test.each(["hoists", "agvs"] as const)("of %s", (name) => {
    const found = (cases[name] as Case[]).flatMap((one) => cases.asked[name].flatMap((asked) => differs(one.features, asked, ofVehicle(one, asked, cases.layouts[name]), one.refused)));
    expect(found).toEqual([]);
  });

  test("of doors and buffers", () => {
    const found = cases.devices.flatMap((one) =>
      cases.asked.devices.flatMap((asked) => {
        const [what, act] = asked.split(" ") as [keyof typeof DEVICES, "open" | "closed" | "close" | "lock" | "unlock"];
        const device = one[DEVICES[what]] as unknown as Device;
        const against = what === "pin" ? againstPin(device, act as "open" | "closed") : againstDevice(device, act as "open" | "close");
        return differs(one.features, asked, against, one.refused);
      }),
    );
    expect(found).toEqual([]);
  });

  test("of drives", () => {
    const found = cases.drives.flatMap((one) =>
      cases.asked.drives.flatMap((asked) => differs(one.features, asked, againstDrive(one.drive as unknown as Drive, asked.split(" ")[0] as Asked, one as unknown as Around), one.refused)),
    );
    expect(found).toEqual([]);
  });

  test("in situations that bring up every reason it knows", () => {
    const source = readFileSync(new URL("../src/against.ts", import.meta.url), "utf-8");
    const words = new Set([...source.matchAll(/"(against_\w+)"/g)].map(([, name]) => name as string));
    words.delete("against_unknown"); // of a device that the page was not told of yet
    expect([...words].filter((word) => !told.has(word))).toEqual([]);
  });
});
