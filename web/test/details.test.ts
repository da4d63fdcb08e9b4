import { describe, expect, test } from "vitest";
import { page as en } from "../../app/texts/en.json";
import { FIELDS, fieldsOf } from "../src/details";

describe("what an audit row keeps of a request", () => {
  test("is read field by field, without what is not so", () => {
    expect(fieldsOf("station SBA-R1, out_of_service bent, by_person False, walked False")).toEqual([
      ["station", "SBA-R1"],
      ["out_of_service", "bent"],
    ]);
    expect(fieldsOf("vehicle V005, what stop")).toEqual([
      ["vehicle", "V005"],
      ["what", "stop"],
    ]);
  });

  test("has switches that are on and the members of a list; a reason may have commas and words of its own", () => {
    expect(fieldsOf("drive D1, inputs SetInputs(run=True, home=False, step=0)")).toEqual([
      ["drive", "D1"],
      ["inputs", "run"],
    ]);
    expect(fieldsOf("reason dust, and smoke, stations ('SBA-R1', 'SBA-R2')")).toEqual([
      ["reason", "dust, and smoke"],
      ["stations", "SBA-R1, SBA-R2"],
    ]);
  });

  test("is left as it is where it is a sentence", () => {
    expect(fieldsOf("refused: V005 is in AUTO, and servo_on needs MANT")).toBeNull();
    expect(fieldsOf("")).toBeNull();
  });

  test("has a word of the page for each field", () => {
    expect(Object.values(FIELDS).filter((word) => !Object.hasOwn(en, word))).toEqual([]);
  });
});
