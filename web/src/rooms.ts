/** In which room, or under which tab, the page shows what a path of the API gives. Pure. */

const ROOM_OF: Record<string, string> = {
  vehicles: "vehicles",
  jobs: "jobs",
  alarms: "alarms",
  closures: "closures",
  zones: "closures",
  controller: "closures",
  stations: "stations",
  carriers: "stations",
  walks: "walks",
  teaching: "teaching",
  statistics: "statistics",
  history: "playback",
  layout: "layouts",
  users: "access",
  keys: "access",
  audit: "audit",
  webhooks: "webhooks",
  devices: "devices",
  drives: "drives",
  operations: "drives",
  links: "lines",
  events: "events",
};

/** The word of the page for the room of a path's first part; "": there is none. */
export const roomOf = (first: string): string => (Object.hasOwn(ROOM_OF, first) ? (ROOM_OF[first] as string) : "");
