/** How the scrubber is drawn: what kind of mark an event has, and what stretch of time is reached over. Pure. */

export type MarkKind = "alarm" | "over" | "closure" | "halt" | "other";

const KINDS: [RegExp, MarkKind][] = [
  [/^(AlarmSet|VehicleBrokenDown|DriveErrorSet|DriveOffline|.*Abort.*|.*Failed)$/, "alarm"],
  [/^(AlarmCleared|VehicleMended|DriveErrorCleared|VehicleReleased|EmergencyReleased|ControllerAuto|ZoneResumed|VehicleInstalled)$/, "over"],
  [/^Place/, "closure"],
  [/^(Emergency|Controller|Zone|VehicleHeld|VehicleRemoved)/, "halt"],
];

export function kindOf(event: string): MarkKind {
  return KINDS.find(([pattern]) => pattern.test(event))?.[1] ?? "other";
}

/** What the scrubber should reach over to show a moment: what it does now, if that is in it. Pure. */
export function reachOf(at: number, span: { from: number; to: number }, length: number, now: { from: number; to: number }): { from: number; to: number } {
  const whole = Math.max(span.to - span.from, 1);
  if (length >= whole) return { from: span.from, to: span.from + whole };
  const fits = Math.abs(now.to - now.from - length) < 1 && now.from <= at && at <= now.to && now.from >= span.from - 1;
  if (fits) return now;
  const from = Math.min(Math.max(at - length / 2, span.from), span.to - length);
  return { from, to: from + length };
}
