/** Compares names as people do: V2 before V10. */
export const NATURAL = new Intl.Collator(undefined, { numeric: true });
