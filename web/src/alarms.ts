/** What is wrong now, from all that the page knows: each with its cause and what helps. Pure but for the catalogue. */
import type { Controller, Device, Drive, Vehicle } from "./types";

export interface Wrong {
  key: string;
  /** What it is about, and of what kind that is. */
  source: string;
  kind: "controller" | "vehicle" | "device" | "drive";
  /** An alarm; else it is kept back by people, or not heard. */
  grave: boolean;
  cause: string;
  remedy: string;
  since: string | null;
}

interface Known {
  controller: Controller | null;
  vehicles: Iterable<Vehicle>;
  devices: Iterable<Device>;
  drives: Iterable<Drive>;
}

export function wrongs({ controller, vehicles, devices, drives }: Known): Wrong[] {
  const list = [
    ...(controller ? ofController(controller) : []),
    ...[...vehicles].flatMap(ofVehicle),
    ...[...devices].flatMap(ofDevice),
    ...[...drives].flatMap(ofDrive),
  ];
  return list.sort((a, b) => Number(b.grave) - Number(a.grave) || (b.since ?? "").localeCompare(a.since ?? ""));
}

function ofController(controller: Controller): Wrong[] {
  const of = (key: string, cause: string, since: string | null = null): Wrong => ({
    key: `controller ${key}`,
    source: controller.plant,
    kind: "controller",
    grave: true,
    cause,
    remedy: "",
    since,
  });
  return [
    ...(controller.trouble ? [of("trouble", controller.trouble)] : []),
    ...controller.emergencies.map((words) => of(words, words)),
    ...controller.circles.map((words) => of(words, words)),
  ];
}

function ofVehicle(vehicle: Vehicle): Wrong[] {
  const { hold, lockout, link } = vehicle;
  const of = (grave: boolean, cause: string, remedy: string, since: string | null): Wrong => ({
    key: `vehicle ${vehicle.id}`,
    source: vehicle.id,
    kind: "vehicle",
    grave,
    cause,
    remedy,
    since,
  });
  if (vehicle.oper === "alarm") {
    const code = vehicle.code ? `0x${vehicle.code.toString(16).toUpperCase().padStart(4, "0")} ${vehicle.code_name}`.trim() : "";
    return [of(true, [code, hold?.reason].filter(Boolean).join(": ") || "alarm", hold?.remedy ?? "", hold?.since ?? null)];
  }
  if (lockout) return [of(false, `locked out by ${lockout.owner}: ${lockout.reason}`, "", lockout.since)];
  if (hold) return [of(false, hold.reason, hold.remedy, hold.since)];
  return link.up || vehicle.activity === "off_rail" ? [] : [of(false, `it is not connected: ${link.reason}`, "", link.since)];
}

function ofDevice(device: Device): Wrong[] {
  const cause = device.alarm || device.contradiction;
  if (!cause) return [];
  return [{ key: `device ${device.id}`, source: device.id, kind: "device", grave: Boolean(device.alarm), cause, remedy: device.remedy, since: device.since }];
}

function ofDrive(drive: Drive): Wrong[] {
  const of = (grave: boolean, cause: string): Wrong[] => [
    { key: `drive ${drive.id}`, source: drive.id, kind: "drive", grave, cause, remedy: drive.remedy, since: drive.seen },
  ];
  if (drive.online && drive.mode === "error") return of(true, drive.error || drive.meaning);
  return drive.online === false ? of(false, drive.reason) : [];
}
