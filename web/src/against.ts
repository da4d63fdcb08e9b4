/**
 * Why the controller would refuse what a button asks for, as far as the page can know it: such a button says so instead of
 * asking. The same reasons in the same order as in app/fleet/orders.py, agv_orders.py, device_orders.py and drive_orders.py. Pure.
 */
import type { Closure, Controller, Device, Drive, Layout, Vehicle } from "./types";

/** A word of the page, and what is filled in; null: nothing speaks against it. */
export type Against = readonly [string, ...(string | number)[]] | null;

/** What a request about a vehicle depends on besides the vehicle. */
export interface Around {
  controller: Pick<Controller, "emergencies" | "waiting_for" | "state" | "reason"> | null;
  closures: Iterable<Closure>;
  layout: Pick<Layout, "stations" | "chargers"> | null;
}

/** What an emergency and a lockout let through: it reads or stops (app/fleet/harmless.py). */
const HARMLESS = new Set(["status", "stop", "stop_by_host", "agv_mark_stop", "agv_lift stop", "agv_charge off"]);
const MANT_ONLY = new Set(["servo_on", "servo_off", "search_home", "go_home", "system_reset", "alarm_clear", "auto"]);

const lockedOut = (of: { lockout: { owner: string; reason: string } | null }): Against =>
  of.lockout ? ["against_lockout", of.lockout.owner, of.lockout.reason] : null;

const emergency = ({ controller }: Pick<Around, "controller">): Against => (controller?.emergencies.length ? ["against_emergency"] : null);

/** People are at work where it stands. */
function atWork(vehicle: Vehicle, { closures }: Around): Against {
  const on = new Set([vehicle.barcode, ...vehicle.covered, ...vehicle.granted]);
  const found = [...closures].find((one) => one.purpose === "work" && one.state === "closed" && one.kind !== "station" && one.barcodes.some((barcode) => on.has(barcode)));
  return found ? ["against_work", found.place, found.owner] : null;
}

const notLinked = (vehicle: Vehicle): Against => (vehicle.link.up && vehicle.mode !== null ? null : ["against_link"]);

/** Why a person's command cannot reach a vehicle, whatever its mode. */
function outOfReach(vehicle: Vehicle, command: string, around: Around): Against {
  const passes = HARMLESS.has(command);
  const barred = passes ? null : (lockedOut(vehicle) ?? atWork(vehicle, around) ?? emergency(around));
  return barred ?? notLinked(vehicle) ?? (vehicle.activity === "recovering" && !passes ? ["against_recovery"] : null);
}

/** A hoist's command without data, or `display`. */
export function againstCommand(vehicle: Vehicle, command: string, around: Around): Against {
  const reach = outOfReach(vehicle, command === "display" ? "stop_by_host" : command, around);
  if (reach) return reach;
  if (MANT_ONLY.has(command) && vehicle.mode !== "mant") return ["against_not_mant", (vehicle.mode ?? "–").toUpperCase()];
  if ((command === "stop_by_host" || command === "display") && vehicle.mode === "mant") return ["against_mant"];
  return command === "display" ? lockedOut(vehicle) : null;
}

/** Why a vehicle cannot be moved, parked or made to handle for a person. */
export function againstMove(vehicle: Vehicle, around: Around): Against {
  if (vehicle.activity === "off_rail") return ["against_off_rail"];
  const barred = lockedOut(vehicle) ?? (vehicle.hold ? (["against_hold"] as const) : null);
  if (barred) return barred;
  if (vehicle.service !== "in_service") return ["against_service"];
  const reach = atWork(vehicle, around) ?? notLinked(vehicle);
  if (reach) return reach;
  if (vehicle.job) return ["against_job", vehicle.job];
  if (vehicle.mode !== "auto") return ["against_not_auto"];
  if (vehicle.oper === "alarm") return ["against_alarm"];
  if (vehicle.activity === "settling" || vehicle.activity === "recovering") return ["against_settling"];
  return around.controller?.waiting_for.length ? ["against_roll_call", around.controller.waiting_for.join(", ")] : null;
}

/** Why a vehicle cannot pick up or put down at a station where it stands. */
export function againstHandling(vehicle: Vehicle, station: string, pickup: boolean, around: Around): Against {
  const found = againstMove(vehicle, around);
  if (found) return found;
  const place = around.layout?.stations.find(({ id }) => id === station);
  if (place && place.barcode !== vehicle.barcode) return ["against_elsewhere", place.barcode, vehicle.barcode ?? "?"];
  return vehicle.loaded === pickup ? [pickup ? "against_loaded" : "against_empty"] : null;
}

/** Why an AGV cannot do what only AGVs are asked (PROTOCOLS 5.3). */
export function againstAgv(vehicle: Vehicle, command: string, around: Around): Against {
  const reach = outOfReach(vehicle, command, around);
  if (reach) return reach;
  const error: Against = vehicle.oper === "alarm" ? ["against_alarm"] : null;
  const busy: Against = error ?? (vehicle.job ? ["against_job", vehicle.job] : vehicle.oper === "run" ? ["against_runs"] : null);
  const auto: Against = vehicle.mode === "auto" ? null : ["against_agv_manual"];
  switch (command) {
    case "alarm_clear":
      return error ? null : ["against_no_error"];
    case "agv_mark_stop":
      return vehicle.oper === "run" ? null : ["against_stands"];
    case "agv_move_manual":
      return vehicle.mode === "mant" ? error : ["against_agv_auto"];
    case "agv_move_auto":
    case "agv_move_alias":
      return auto ?? busy;
    case "agv_charge on":
      return auto ?? busy ?? (around.layout?.chargers.some(({ barcode }) => barcode === vehicle.barcode) ? null : ["against_no_charger"]);
    case "agv_set_current":
    case "agv_lift up":
    case "agv_lift down":
      return busy;
    default:
      return null;
  }
}

/** Why an alarm is not recovered from now. */
export function againstRecovery(vehicle: Vehicle, around: Around): Against {
  return lockedOut(vehicle) ?? atWork(vehicle, around) ?? emergency(around) ?? notLinked(vehicle);
}

/** Why a person's verdict about a held or absent vehicle would be refused. */
export function againstVerdict(vehicle: Vehicle, verdict: "go_on" | "off_rail" | "stands_at"): Against {
  if (verdict !== "go_on") return vehicle.link.up ? ["against_linked"] : null;
  if (vehicle.oper === "alarm") return ["against_alarm"];
  return vehicle.hold || vehicle.activity === "off_rail" ? null : ["against_nothing_held"];
}

/** Why a door or buffer would not be asked for this. */
export function againstDevice(device: Device | undefined, command: "open" | "close" | "lock" | "unlock"): Against {
  if (!device) return ["against_unknown"];
  const lockout = lockedOut(device);
  if (lockout) return lockout;
  if (command !== "open" && !device.fresh) return ["against_silent"];
  if (command === "lock" || command === "unlock") return device.lock && !device.lock.person ? ["against_locked_for", device.lock.owner] : null;
  const wanted = command === "open" ? "open" : "closed";
  if (device.pin && device.pin.position !== wanted) return ["against_pin", device.pin.owner];
  return command === "close" && device.vehicles.length > 0 ? ["against_engaged", device.vehicles.join(", ")] : null;
}

/** Why a door cannot be kept open or closed now. */
export function againstPin(device: Device, position: "open" | "closed"): Against {
  return lockedOut(device) ?? (position === "closed" && device.vehicles.length > 0 ? ["against_engaged", device.vehicles.join(", ")] : null);
}

/** What is asked of a drive: it reads its status or stops (`harmless`), reads, writes, or sets the axis moving. */
export type Asked = "harmless" | "read" | "change" | "write" | "move" | "jog";

export function againstDrive(drive: Drive, asked: Asked, around: Pick<Around, "controller">): Against {
  const harmless = asked === "harmless";
  const lockout = harmless ? null : lockedOut(drive);
  if (lockout) return lockout;
  if (drive.online === null && drive.reason) return ["against_line", drive.line];
  if (drive.online === false && !harmless) return ["against_offline"];
  if (harmless || asked === "read") return null;
  if (drive.operation !== null) return ["against_operation", drive.operation];
  if (asked === "write") return drive.moving ? ["against_drive_runs"] : null;
  if (asked === "change") return null;
  const still = emergency(around) ?? (drive.mode === "error" ? (["against_drive_error"] as const) : null);
  return still ?? (asked === "jog" && drive.mode !== null && drive.mode !== "jog" ? ["against_not_jog"] : null);
}
