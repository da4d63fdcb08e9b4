/** Which room of the page is open and what is chosen in it, kept in the address: it can be sent to somebody. */
import { effect, signal } from "@preact/signals";
import { type Selection, selected } from "./store";

export const ROOMS = ["map", "vehicles", "jobs", "alarms", "closures", "stations", "walks", "teaching", "statistics", "layouts", "access", "audit", "webhooks"] as const;
export type Room = (typeof ROOMS)[number];

const KINDS = new Set(["vehicle", "station", "device", "drive", "job"]);
export const room = signal<Room>("map");

function isRoom(name: string): name is Room {
  return (ROOMS as readonly string[]).includes(name);
}

function read(): void {
  const [path = "", query = ""] = location.hash.replace(/^#\/?/, "").split("?");
  room.value = isRoom(path) ? path : "map";
  const [[kind, id] = []] = [...new URLSearchParams(query)];
  if (kind && id && KINDS.has(kind)) selected.value = { kind, id } as Selection;
}

/** Follow the address, and keep it up to date. */
export function begin(): void {
  read();
  window.addEventListener("hashchange", read);
  effect(() => {
    const pick = selected.value;
    const query = pick ? `?${new URLSearchParams({ [pick.kind]: pick.id })}` : "";
    const next = `#/${room.value}${query}`;
    if (location.hash !== next) history.replaceState(null, "", next);
  });
}
