/** Alarms that have one cause, together: thirty hoists that lost one switch are one thing to know of. Pure. */
import { againstVerdict } from "./against";
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

/** Whether a vehicle's hold may be released with others' by saying that its report is right: it reports, and is held for no alarm. */
export function releasable(vehicle: Vehicle | undefined): boolean {
  return Boolean(vehicle?.link.up && againstVerdict(vehicle, "go_on") === null);
}
