/** The page chooses Korean particles as the API and the command line do: by the same cases. */
import { describe, expect, it } from "vitest";
import cases from "../../tests/particles.json";
import { settled, soundOf } from "../src/particles";

describe("particles", () => {
  it("go by how a name is read aloud", () => {
    for (const [name, sound] of cases.sounds) expect(soundOf(name ?? ""), `${name}`).toBe(sound);
  });

  it("are chosen where that can be told, and both stand where it cannot", () => {
    for (const [written, expected] of cases.settled) {
      expect(settled(written ?? "")).toBe(expected);
      expect(settled(expected ?? "")).toBe(expected);
    }
  });
});
