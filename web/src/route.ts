/** Which room of the page is open and what is chosen in it, kept in the address: it can be sent to somebody. */
import { effect, signal } from "@preact/signals";
import { notice, type Selection, selected } from "./store";
import { t } from "./texts";

export const ROOMS = ["map", "vehicles", "jobs", "alarms", "closures", "stations", "walks", "teaching", "statistics", "playback", "layouts", "access", "audit", "webhooks"] as const;
export type Room = (typeof ROOMS)[number];

const KINDS = new Set(["vehicle", "station", "device", "drive", "job"]);
export const room = signal<Room>("map");
/** The moment of the past that the address asks for, and the one that it is to name; ISO 8601. */
export const momentAsked = signal<string | null>(null);
export const momentShown = signal<string | null>(null);

function isRoom(name: string): name is Room {
  return (ROOMS as readonly string[]).includes(name);
}

/** What people write by hand. */
const ALSO: Record<string, Room> = { layout: "layouts", users: "access", keys: "access", closure: "closures", carriers: "stations", history: "playback" };

function read(): void {
  const [path = "", query = ""] = location.hash.replace(/^#\/?/, "").split("?");
  const known = isRoom(path) ? path : ALSO[path];
  room.value = known ?? "map";
  strayed(path && !known ? t("no_room", path) : "");
  const asked = new URLSearchParams(query);
  momentAsked.value = room.value === "playback" ? asked.get("at") : null;
  const [kind, id] = [...asked].find(([name]) => KINDS.has(name)) ?? [];
  if (kind && id) selected.value = { kind, id } as Selection;
}

let said = "";

/** Say once that there is no room of that name, until another is entered; "": there is. */
function strayed(words: string): void {
  if (said && notice.value === said) notice.value = "";
  said = words;
  if (words) notice.value = words;
}

/** Follow the address, and keep it up to date. */
export function begin(): void {
  read();
  window.addEventListener("hashchange", read);
  room.subscribe((now) => now !== "map" && strayed(""));
  effect(() => {
    const pick = selected.value;
    const asked = new URLSearchParams(pick ? { [pick.kind]: pick.id } : {});
    const at = momentShown.value ?? momentAsked.peek();
    if (room.value === "playback" && at) asked.set("at", at);
    const query = String(asked).replaceAll("%3A", ":");
    const next = `#/${room.value}${query && `?${query}`}`;
    if (location.hash !== next) history.replaceState(null, "", next);
  });
}
