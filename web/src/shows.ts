/** How things look: colours by what a vehicle does, ages, times. Pure. */
import type { Device, Drive, Job, Vehicle } from "./types";

export type Look = "idle" | "moving" | "waiting" | "handling" | "charging" | "held" | "alarm" | "gone";

/** As custom properties of the style sheet, which has them for each theme. */
export const LOOKS: Record<Look, string> = {
  idle: "var(--look-idle)",
  moving: "var(--look-moving)",
  waiting: "var(--look-waiting)",
  handling: "var(--look-handling)",
  charging: "var(--look-charging)",
  held: "var(--look-held)",
  alarm: "var(--look-alarm)",
  gone: "var(--look-gone)",
};

/** Beside a name, for whom colours say little: each look has a sign of its own, and only who is idle has none. */
export const SIGNS: Record<Look, string> = {
  idle: "",
  moving: "›",
  waiting: "…",
  handling: "↕",
  charging: "↯",
  held: "‖",
  alarm: "!",
  gone: "?",
};

const LOOK_OF: Record<string, Look> = {
  idle: "idle",
  moving: "moving",
  waiting: "waiting",
  busy: "waiting",
  paused: "waiting",
  acquiring: "handling",
  depositing: "handling",
  charging: "charging",
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

export type DeviceLook = "open" | "closed" | "cart" | "no_cart" | "charging" | "free" | "busy" | "unknown" | "error" | "silent";

export const DEVICE_LOOKS: Record<DeviceLook, string> = {
  open: "var(--device-open)",
  closed: "var(--device-closed)",
  cart: "var(--device-cart)",
  no_cart: "var(--device-no_cart)",
  charging: "var(--device-charging)",
  free: "var(--device-free)",
  busy: "var(--device-busy)",
  unknown: "var(--device-unknown)",
  error: "var(--device-error)",
  silent: "var(--device-silent)",
};

/** How a door or buffer looks: what it said counts only while it is heard. A charger says nothing itself. */
export function lookOfDevice(device: Device | undefined, charging = false): DeviceLook {
  if (device?.kind === "charger") return charging || device.vehicles?.length ? "charging" : "free";
  if (!device?.fresh) return "silent";
  const state = device.state ?? "unknown";
  return Object.hasOwn(DEVICE_LOOKS, state) ? (state as DeviceLook) : "unknown";
}

const MODES = { parameter_select: 0, parameter_value: 0, monitoring: 0, jog: 0, error: 0 };
export type DriveWord = keyof typeof MODES | "offline" | "not_heard" | "online";

/** The sign beside a name for what colour alone does not say: an alarm, or that nobody knows. */
export function signOfDevice(device: Device | undefined, look: DeviceLook): string {
  if (device?.alarm || look === "error") return "!";
  return look === "unknown" || look === "silent" ? "?" : look === "busy" ? "…" : "";
}

/** Its colour, or that of an alarm. */
export function colourOfDevice(device: Device | undefined, look: DeviceLook): string {
  return DEVICE_LOOKS[device?.alarm ? "error" : look];
}

/** What a drive does, in one word: that of its mode, or why there is none. */
export function lookOfDrive(drive: Drive): { word: DriveWord; tone: Tone } {
  if (drive.online === null) return { word: "not_heard", tone: "wait" };
  if (!drive.online) return { word: "offline", tone: "bad" };
  if (drive.mode === null) return { word: "online", tone: "calm" };
  const tone = drive.mode === "error" ? "bad" : drive.mode === "jog" ? "go" : drive.mode === "monitoring" ? "good" : "calm";
  return { word: Object.hasOwn(MODES, drive.mode) ? (drive.mode as DriveWord) : "online", tone };
}

/** A distance in hundredths, as people read it. */
export function hundredths(distance: number): string {
  return (distance / 100).toFixed(2);
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
/** Day and time of day, for what may lie long ago. */
export function moment(iso: string): string {
  const at = new Date(iso);
  return Number.isNaN(at.getTime()) ? "" : `${at.toLocaleDateString("sv-SE")} ${clock(iso)}`;
}

export function clock(iso: string): string {
  const at = new Date(iso);
  return Number.isNaN(at.getTime()) ? "" : at.toLocaleTimeString("en-GB", { hour12: false });
}
