/** A table that can be sorted by any column and gone through by key; long ones show their beginning. */
import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { none as noneOr } from "../known";
import { NATURAL } from "../store";
import { t } from "../texts";

export interface Column<T> {
  name: string;
  of: (row: T) => ComponentChildren;
  /** What it is sorted by; without it the column cannot be. */
  by?: (row: T) => string | number | null;
  number?: boolean;
  /** Sentences: they may be broken into lines, and nothing else is then. */
  wraps?: boolean;
}

interface Props<T> {
  label: string;
  /** Undefined: they were not read yet. */
  rows: T[] | undefined;
  columns: Column<T>[];
  keyOf: (row: T) => string;
  /** What happens when a row is chosen; without it none can be. */
  pick?: (row: T) => void;
  chosen?: string | null;
  /** What stands there when there is none. */
  none: string;
}

const SHOWN = 200;

function compare(a: string | number | null, b: string | number | null): number {
  if (a === null || b === null) return a === b ? 0 : a === null ? 1 : -1;
  return typeof a === "number" && typeof b === "number" ? a - b : NATURAL.compare(String(a), String(b));
}

export function Table<T>({ label, rows: given, columns, keyOf, pick, chosen, none }: Props<T>) {
  const rows = given ?? [];
  const order = useSignal<{ column: number; down: boolean } | null>(null);
  const shown = useSignal(SHOWN);
  const by = order.value ? columns[order.value.column]?.by : undefined;
  const sign = order.value?.down ? -1 : 1;
  const sorted = by ? rows.toSorted((a, b) => sign * compare(by(a), by(b))) : rows;
  const sort = (column: number): void => {
    const now = order.value;
    if (now?.column !== column) order.value = { column, down: false };
    else order.value = now.down ? null : { column, down: true };
  };
  return (
    <div class="scroll" tabIndex={0} role="group" aria-label={label}>
      <table class={columns.some(({ wraps }) => wraps) ? "list tidy" : "list"}>
        <thead>
          <tr>
            {columns.map((column, i) => {
              const sorts = order.value?.column === i ? (order.value.down ? "descending" : "ascending") : "none";
              return (
                <th key={column.name} class={column.number ? "number" : ""} aria-sort={column.by ? sorts : undefined}>
                  {column.by ? (
                    <button type="button" onClick={() => sort(i)}>
                      {column.name} {sorts === "ascending" ? "▲" : sorts === "descending" ? "▼" : ""}
                    </button>
                  ) : (
                    <span>{column.name}</span>
                  )}
                </th>
              );
            })}
          </tr>
        </thead>
        <tbody>
          {sorted.slice(0, shown.value).map((row) => {
            const key = keyOf(row);
            return (
              <tr
                key={key}
                data-row={key}
                class={pick ? "pick" : ""}
                aria-selected={pick ? chosen === key : undefined}
                onClick={(event) => {
                  if (!(event.target as Element).closest("button, input, select, a")) pick?.(row);
                }}
              >
                {columns.map((column) => (
                  <td key={column.name} class={column.number ? "number" : column.wraps ? "wraps" : ""}>
                    {column.of(row)}
                  </td>
                ))}
              </tr>
            );
          })}
        </tbody>
      </table>
      {rows.length === 0 && <p class="nothing">{given ? noneOr(none) : noneOr(t("loading"))}</p>}
      {rows.length > shown.value && (
        <p class="more-rows">
          {t("more_rows", rows.length - shown.value)}{" "}
          <button type="button" onClick={() => (shown.value += SHOWN)}>
            {t("show_more")}
          </button>
        </p>
      )}
    </div>
  );
}
