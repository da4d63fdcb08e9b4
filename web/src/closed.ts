/** Which track people have closed or are about to close, for the map. */
import { computed, signal } from "@preact/signals";
import { closureList, layout } from "./store";

/** A stretch of track, from one barcode to another, in no language. */
export const placed = (place: string): string => place.replace(/^(\S+) to (\S+)$/, "$1 → $2");

/** Told which barcode was clicked, while somebody chooses track on the map. */
export const choosing = signal<((barcode: string) => void) | null>(null);
/** Barcodes that a closure that is only looked at would keep empty. */
export const previewed = signal<string[]>([]);

/** Pairs of barcodes: the way from the first to the second is closed. */
export const closedWays = computed<[string, string][]>(() => {
  const list = closureList.value;
  const barcodes = new Set(list.filter(({ kind }) => kind !== "edge" && kind !== "station").flatMap((one) => one.barcodes));
  const edges = list.filter(({ kind }) => kind === "edge").map(({ names }) => [names[0], names[1]] as [string, string]);
  return [...edges, ...waysInto(barcodes)];
});

export const previewedWays = computed(() => waysInto(new Set(previewed.value)));

function waysInto(barcodes: ReadonlySet<string>): [string, string][] {
  if (barcodes.size === 0) return [];
  return (layout.value?.edges ?? []).filter(({ end }) => barcodes.has(end)).map(({ start, end }) => [start, end]);
}
