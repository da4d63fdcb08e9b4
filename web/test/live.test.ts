import { describe, expect, test } from "vitest";
import { type Sink, Stream } from "../src/live";
import type { Happening } from "../src/types";

function heard() {
  const said: string[] = [];
  const sink: Sink = {
    snapshot: (objects, last) => said.push(`snapshot ${Object.keys(objects).join()} ${last}`),
    change: (topic, key, value) => said.push(`${topic}/${key}=${JSON.stringify(value)}`),
    changed: () => said.push("changed"),
    events: (events) => said.push(`events ${events.map((event) => event.seq).join()}`),
    forget: () => said.push("forget"),
    problem: (text) => said.push(`problem ${text}`),
  };
  return { said, stream: new Stream(sink) };
}

const frame = (value: object): string => JSON.stringify(value);
const snapshot = (seq: number, last = 0): string => frame({ type: "snapshot", seq, last_event: last, objects: { jobs: {} } });
const change = (seq: number): string =>
  frame({ type: "change", seq, changes: [{ topic: "jobs", key: "J1", value: null }] });
const events = (...seqs: number[]): string =>
  frame({ type: "event", events: seqs.map((seq) => ({ seq }) as Happening) });

describe("the stream", () => {
  test("takes changes that follow the snapshot by number", () => {
    const { said, stream } = heard();
    stream.take(snapshot(4));
    expect(stream.take(change(5))).toBeNull();
    expect(said).toEqual(["snapshot jobs 0", "jobs/J1=null", "changed"]);
  });

  test("asks for a resync when a number is missing, and ignores changes until the snapshot", () => {
    const { said, stream } = heard();
    stream.take(snapshot(4));
    expect(stream.take(change(6))).toEqual({ say: '{"resync":true}' });
    expect(stream.take(change(7))).toBeNull();
    stream.take(frame({ type: "resync" }));
    stream.take(snapshot(9));
    stream.take(change(10));
    expect(said.filter((line) => line === "changed")).toHaveLength(1);
  });

  test("takes each event once, across connections", () => {
    const { said, stream } = heard();
    stream.take(snapshot(0, 7));
    stream.take(events(8, 9));
    stream.restart();
    stream.take(snapshot(0, 9));
    stream.take(events(9, 10));
    expect(stream.lastEvent).toBe(10);
    expect(said.filter((line) => line.startsWith("events"))).toEqual(["events 8,9", "events 10"]);
  });

  test("does not skip events that happened while it was away", () => {
    const { stream } = heard();
    stream.take(snapshot(0, 7));
    stream.restart();
    stream.take(snapshot(0, 12));
    expect(stream.lastEvent).toBe(7);
  });

  test("begins anew where the server has another history", () => {
    const { said, stream } = heard();
    stream.take(snapshot(0, 500));
    stream.restart();
    expect(stream.take(snapshot(0, 3))).toBe("reconnect");
    expect(stream.lastEvent).toBe(3);
    expect(said).toContain("forget");
  });

  test("tells what the server refused", () => {
    const { said, stream } = heard();
    stream.take(frame({ type: "error", problem: { detail: "too many watch" } }));
    expect(said).toEqual(["problem too many watch"]);
  });
});
