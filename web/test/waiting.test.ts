import { expect, test } from "vitest";
import type { Vehicle } from "../src/types";
import { rootOf } from "../src/waiting";

const fleet = (waits: Record<string, string | null>) => {
  const vehicles = new Map(Object.entries(waits).map(([id, waits_for]) => [id, { id, waits_for } as Vehicle]));
  return (id: string) => rootOf(vehicles.get(id) as Vehicle, (name) => vehicles.get(name))?.id ?? null;
};

test("the root of a chain of waits is who waits for nobody", () => {
  const root = fleet({ V1: null, V2: "V1", V3: "V2", V4: "V3" });
  expect([root("V1"), root("V2"), root("V4")]).toEqual([null, "V1", "V1"]);
});

test("a circle has no root, nor has a wait for one that is not there", () => {
  const root = fleet({ V1: "V2", V2: "V1", V3: "V9" });
  expect([root("V1"), root("V3")]).toEqual([null, null]);
});
