/** What the page can be asked for by name. */
import { devices, drives, jobs, layout, NATURAL, type Selection, stations, vehicles } from "./store";

export interface Found {
  kind: NonNullable<Selection>["kind"] | "barcode";
  id: string;
  /** Where something that has no place of its own is: the vehicle or station. */
  at?: NonNullable<Selection>;
}

const MOST = 12;

/** Things whose name has these letters in it, those that begin with them first. */
export function find(letters: string): Found[] {
  const wanted = letters.trim().toLowerCase();
  if (!wanted) return [];
  const names = (kind: Found["kind"], ids: Iterable<string>): Found[] =>
    [...ids].filter((id) => id.toLowerCase().includes(wanted)).map((id) => ({ kind, id }));
  const carried: Found[] = [
    ...[...vehicles.values()].map(({ id, carrier }) => ({ kind: "vehicle" as const, id, carrier })),
    ...[...stations.values()].map(({ id, carrier }) => ({ kind: "station" as const, id, carrier })),
  ]
    .filter(({ carrier }) => carrier?.toLowerCase().includes(wanted))
    .map(({ kind, id, carrier }) => ({ kind, id: carrier as string, at: { kind, id } }));
  const barcodes = wanted.length > 1 ? names("barcode", (layout.value?.points ?? []).map(({ barcode }) => barcode)) : [];
  const all = [
    ...names("vehicle", vehicles.keys()),
    ...names("station", stations.keys()),
    ...names("job", jobs.keys()),
    ...carried,
    ...names("device", devices.keys()),
    ...names("drive", drives.keys()),
    ...barcodes,
  ];
  const rank = ({ id }: Found): number => (id.toLowerCase() === wanted ? 0 : id.toLowerCase().startsWith(wanted) ? 1 : 2);
  return all.sort((a, b) => rank(a) - rank(b) || NATURAL.compare(a.id, b.id)).slice(0, MOST);
}
