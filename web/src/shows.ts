/** How things look: colours by what a vehicle does, ages, times. Pure. */
import type { Job, Vehicle } from "./types";

export type Look = "idle" | "moving" | "waiting" | "handling" | "held" | "alarm" | "gone";

export const LOOKS: Record<Look, string> = {
  idle: "#93a8bd",
  moving: "#45bdff",
  waiting: "#ffd24d",
  handling: "#bba0ff",
  held: "#ff9640",
  alarm: "#ff5c5c",
  gone: "#66788a",
};

const LOOK_OF: Record<string, Look> = {
  idle: "idle",
  moving: "moving",
  waiting: "waiting",
  busy: "waiting",
  paused: "waiting",
  acquiring: "handling",
  depositing: "handling",
  settling: "held",
  held: "held",
  locked_out: "held",
  recovering: "held",
  alarm: "alarm",
  absent: "gone",
  off_rail: "gone",
};

export function lookOf(vehicle: Vehicle): Look {
  if (vehicle.oper === "alarm" && vehicle.activity !== "absent") return "alarm";
  const look = LOOK_OF[vehicle.activity] ?? "idle";
  return look === "idle" && !vehicle.link.up ? "gone" : look;
}

export type Tone = "calm" | "go" | "wait" | "good" | "bad";

export const TONES: Record<string, Tone> = {
  queued: "calm",
  waiting: "wait",
  transferring: "go",
  paused: "wait",
  cancelling: "wait",
  aborting: "wait",
  completed: "good",
  failed: "bad",
  cancelled: "calm",
  aborted: "bad",
};

/** 7 s, 3:05, 1:02:10, 3 d. */
export function span(ms: number): string {
  const s = Math.max(0, Math.floor(ms / 1000));
  const two = (n: number): string => String(n).padStart(2, "0");
  if (s < 60) return `${s} s`;
  if (s < 3600) return `${Math.floor(s / 60)}:${two(s % 60)}`;
  if (s < 86_400) return `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
  return `${Math.floor(s / 86_400)} d`;
}

export function elapsed(job: Job, now: number): string {
  return span((job.ended ? Date.parse(job.ended) : now) - Date.parse(job.created));
}

/** Time of day at this place. */
export function clock(iso: string): string {
  const at = new Date(iso);
  return Number.isNaN(at.getTime()) ? "" : at.toLocaleTimeString("en-GB", { hour12: false });
}

/** VehicleAcquireStarted -> Vehicle acquire started. */
export function sentence(event: string): string {
  const words = event.replace(/([a-z])([A-Z])/g, "$1 $2").toLowerCase();
  return words.charAt(0).toUpperCase() + words.slice(1);
}
