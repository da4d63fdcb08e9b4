/** Which track people have closed, for the map. */
import { signal } from "@preact/signals";

/** Pairs of barcodes: the way from the first to the second is closed. */
export const closedWays = signal<[string, string][]>([]);
