/** Alarms that have one cause, together: thirty hoists that lost one switch are one thing to know of. Pure. */
import type { Alarm, Vehicle } from "./types";

export interface Group {
  key: string;
  /** Newest first. */
  alarms: Alarm[];
  /** The cause that all have, with a dash for what is each one's own. */
  cause: string;
  remedy: string;
}

const OWN = /\S*\d\S*/g;

/** A cause without the names and numbers in it, each of which is one machine's own. */
export function plainOf(alarm: Alarm): string {
  return alarm.cause.replaceAll(alarm.source, "–").replace(OWN, "–");
}

/** What is put together: of the same kind and code; a hold has one code, so that its cause tells them apart. */
const keyOf = (alarm: Alarm): string => `${alarm.kind} ${alarm.code} ${alarm.kind === "hold" ? plainOf(alarm) : ""}`;

/** Groups in the order of their newest alarm, as the list has them. */
export function groupsOf(list: readonly Alarm[]): Group[] {
  const groups = new Map<string, Group>();
  for (const alarm of list) {
    const key = keyOf(alarm);
    const group = groups.get(key);
    if (!group) groups.set(key, { key, alarms: [alarm], cause: alarm.cause, remedy: alarm.remedy });
    else {
      group.alarms.push(alarm);
      if (group.cause !== alarm.cause) group.cause = plainOf(alarm);
      if (group.remedy !== alarm.remedy) group.remedy = "";
    }
  }
  return [...groups.values()];
}

/** Why the hold of a vehicle may not be released now by saying that its report is right; "": it may. The word is the page's. */
export function againstRelease(vehicle: Vehicle | undefined): "" | "not_held" | "release_not_linked" | "release_in_alarm" {
  if (!vehicle || (!vehicle.hold && vehicle.activity !== "off_rail")) return "not_held";
  if (vehicle.oper === "alarm") return "release_in_alarm";
  return vehicle.link.up ? "" : "release_not_linked";
}
