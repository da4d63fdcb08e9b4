/**
 * Why the controller would refuse what a button asks for, as far as the page can know it: such a button says so instead of
 * asking. The same reasons in the same order as in app/fleet/orders.py, agv_orders.py, device_orders.py and drive_orders.py:
 * test/against.cases.test.ts compares them with what those answer. What the controller would do is never refused here. Pure.
 */
import type { Closure, Controller, Device, Drive, Layout, Vehicle } from "./types";

/** A word of the page, and what is filled in; null: nothing speaks against it. */
export type Against = readonly [string, ...(string | number)[]] | null;

/** What a request about a vehicle depends on besides the vehicle. */
export interface Around {
  controller: Pick<Controller, "emergencies" | "waiting_for" | "state" | "reason"> | null;
  closures: Iterable<Closure>;
  layout: Pick<Layout, "stations" | "chargers" | "vehicles" | "edges"> | null;
  /** All of the plant, for the roll-call: those that are missing matter only where they may be in the way. */
  vehicles: Iterable<Pick<Vehicle, "id" | "mode" | "barcode">>;
}

/** What an emergency and a lockout let through: it reads or stops (app/fleet/harmless.py). */
const HARMLESS = new Set(["status", "stop", "stop_by_host", "agv_mark_stop", "agv_lift stop", "agv_charge off"]);
const MANT_ONLY = new Set(["servo_on", "servo_off", "search_home", "go_home", "system_reset", "alarm_clear", "auto"]);

/** Something that it was told is not over, though it may stand. */
const DOING = new Set(["moving", "acquiring", "depositing"]);

const lockedOut = (of: { lockout: { owner: string; reason: string } | null }): Against =>
  of.lockout ? ["against_lockout", of.lockout.owner, of.lockout.reason] : null;

const emergency = ({ controller }: Pick<Around, "controller">): Against => (controller?.emergencies.length ? ["against_emergency"] : null);

/** People are at work where it stands. What it covers counts, not what it says: it may not be believed there yet. */
function atWork(vehicle: Vehicle, { closures }: Around): Against {
  const on = new Set([...vehicle.covered, ...vehicle.granted]);
  const found = [...closures].find((one) => one.purpose === "work" && one.state === "closed" && one.kind !== "station" && one.barcodes.some((barcode) => on.has(barcode)));
  return found ? ["against_work", found.place, found.owner] : null;
}

const cut = (vehicle: Vehicle): Against => (vehicle.link.up ? null : ["against_link"]);
/** Nor has it said anything yet. */
const notLinked = (vehicle: Vehicle): Against => cut(vehicle) ?? (vehicle.mode === null ? ["against_link"] : null);

/** The stretches of track that no edge joins, each named by a barcode of it; of the layout that was asked about last. */
let parted: { of: unknown; names: Map<string, string> } = { of: null, names: new Map() };

function stretchOf(barcode: string, layout: NonNullable<Around["layout"]>): string {
  if (parted.of !== layout) {
    const above = new Map<string, string>();
    const top = (name: string): string => {
      let at = name;
      for (let next = above.get(at); next !== undefined && next !== at; next = above.get(at)) {
        above.set(at, above.get(next) ?? next);
        at = next;
      }
      return at;
    };
    for (const { start, end } of layout.edges) {
      const [a, b] = [top(start), top(end)];
      if (!above.has(b)) above.set(b, b);
      above.set(a, b);
    }
    parted = { of: layout, names: new Map([...above.keys()].map((name) => [name, top(name)])) };
  }
  return parted.names.get(barcode) ?? barcode;
}

/**
 * Who is missing since the start and may be on this vehicle's stretch of track: whose last place lies on it, or who may be
 * wherever its kind drives. One that has said something by now is left to the controller: it may be believed elsewhere.
 */
function missing(vehicle: Vehicle, { controller, layout, vehicles }: Around): string[] {
  const names = controller?.waiting_for ?? [];
  if (names.length === 0 || !layout || vehicle.barcode === null) return [];
  const here = stretchOf(vehicle.barcode, layout);
  const kinds = new Map(layout.vehicles.map(({ id, kind }) => [id, kind]));
  const known = new Map([...vehicles].map((one) => [one.id, one]));
  return names.filter((name) => {
    const other = known.get(name);
    if (!other || other.mode !== null) return false;
    return other.barcode === null ? kinds.get(name) === kinds.get(vehicle.id) : stretchOf(other.barcode, layout) === here;
  });
}

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
  if ((command === "stop_by_host" || command === "display") && vehicle.mode !== "auto" && vehicle.mode !== "semi") return ["against_mant"];
  return command === "display" ? lockedOut(vehicle) : null;
}

/** Why a vehicle cannot be moved, parked or made to handle for a person. */
export function againstMove(vehicle: Vehicle, around: Around): Against {
  if (vehicle.activity === "off_rail") return ["against_off_rail"];
  const barred = lockedOut(vehicle) ?? (vehicle.hold ? (["against_hold"] as const) : null);
  if (barred) return barred;
  if (vehicle.service !== "in_service") return ["against_service"];
  const reach = atWork(vehicle, around) ?? cut(vehicle);
  if (reach) return reach;
  if (vehicle.job) return ["against_job", vehicle.job];
  if (vehicle.mode !== "auto") return ["against_not_auto"];
  if (vehicle.oper === "alarm") return ["against_alarm"];
  if (vehicle.activity === "settling" || vehicle.activity === "recovering") return ["against_settling"];
  const absent = missing(vehicle, around);
  return absent.length ? ["against_roll_call", absent.join(", ")] : null;
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
  const runs = vehicle.oper === "run" || DOING.has(vehicle.activity);
  const busy: Against = error ?? (vehicle.job ? ["against_job", vehicle.job] : runs ? ["against_runs"] : null);
  const auto: Against = vehicle.mode === "auto" ? null : ["against_agv_manual"];
  switch (command) {
    case "alarm_clear":
      return error ? null : ["against_no_error"];
    case "agv_mark_stop":
      return vehicle.oper === "run" ? null : ["against_stands"];
    case "agv_move_manual":
      return vehicle.mode === "mant" ? error : ["against_agv_auto"];
    case "agv_move_auto":
      return auto ?? busy;
    case "agv_move_alias":
      return auto ?? busy ?? againstMove(vehicle, around);
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
