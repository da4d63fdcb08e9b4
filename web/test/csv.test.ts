import { describe, expect, it } from "vitest";
import { csvOf, rowsOf } from "../src/csv";

describe("tables as files", () => {
  it("come back as they were written, whatever stands in them", () => {
    const rows = [
      { station: "B1", note: 'said "no", twice\nand left' },
      { station: "=SUM(A1)", note: "-" },
    ];
    expect(rowsOf(csvOf(["station", "note"], rows))).toEqual(rows);
  });

  it("give nothing that a spreadsheet would reckon", () => {
    expect(csvOf(["who"], [{ who: "=cmd()" }])).toContain("'=cmd()");
  });

  it("may be parted by semicolons, and have blank lines", () => {
    expect(rowsOf("Station;Carrier\r\nB1;F1\r\n\r\n;\r\nB2;\r\n")).toEqual([
      { station: "B1", carrier: "F1" },
      { station: "B2", carrier: "" },
    ]);
  });

  it("say what is wrong with them", () => {
    expect(() => rowsOf('station\n"B1')).toThrow("never closed");
  });
});
