/** Alarms of the past, of one machine or of a kind, page after page. */
import { type Signal, useSignal } from "@preact/signals";
import { get } from "../api";
import { clock, span } from "../shows";
import { changes } from "../store";
import { said, t, tell } from "../texts";
import type { Alarm } from "../types";
import { useRead } from "./asking";
import { Name } from "./Name";
import { Problem } from "./Problem";
import { Table } from "./Table";

const KINDS = ["vehicle", "hold", "link", "device", "drive", "traffic", "job", "plant"] as const;
const PAGE = 200;

interface Page {
  items: Alarm[];
  next: number | null;
}

const lasted = (alarm: Alarm): number => (alarm.ended ? Date.parse(alarm.ended) - Date.parse(alarm.begun) : Number.POSITIVE_INFINITY);

export function AlarmHistory({ source }: { source: Signal<string> }) {
  const kind = useSignal("");
  const older = useSignal<{ query: string; items: Alarm[]; next: number | null } | null>(null);
  const error = useSignal<unknown>(null);
  const query = String(new URLSearchParams({ limit: String(PAGE), ...(source.value.trim() ? { source: source.value.trim() } : {}), ...(kind.value ? { kind: kind.value } : {}) }));
  const first = useRead<Page>(`/alarms?${query}`, changes.alarms.value);
  const more = older.value?.query === query ? older.value : null;
  const next = more ? more.next : (first.value?.next ?? null);
  const known = new Set(first.value?.items.map(({ id }) => id));
  const rows = [...(first.value?.items ?? []), ...(more?.items ?? []).filter(({ id }) => !known.has(id))];
  const goOn = async (): Promise<void> => {
    try {
      const page = await get<Page>(`/alarms?${query}&after=${next}`);
      older.value = { query, items: [...(more?.items ?? []), ...page.items], next: page.next };
      error.value = null;
    } catch (failure) {
      error.value = failure;
    }
  };
  return (
    <div class="filtered">
      <div class="filters">
        <label>
          <span>{t("name")}</span>
          <input type="search" value={source.value} onChange={(event) => (source.value = event.currentTarget.value)} />
        </label>
        <label>
          <span>{t("kind")}</span>
          <select value={kind.value} onChange={(event) => (kind.value = event.currentTarget.value)}>
            <option value="">{t("all")}</option>
            {KINDS.map((name) => (
              <option key={name} value={name}>
                {said(name)}
              </option>
            ))}
          </select>
        </label>
        <button type="button" disabled={next === null} onClick={() => void goOn()}>
          {t("older_rows")}
        </button>
        <Problem error={error.value ?? first.error} />
      </div>
      <Table
        label={t("alarms_history")}
        rows={first.value ? rows : undefined}
        keyOf={(row) => String(row.id)}
        none={t("no_alarms_yet")}
        columns={[
          { name: "#", by: (row) => row.id, of: (row) => row.id, number: true },
          { name: t("when"), by: (row) => row.begun, of: (row) => `${row.begun.slice(5, 10)} ${clock(row.begun)}` },
          { name: t("kind"), by: (row) => row.kind, of: (row) => said(row.kind) },
          { name: t("name"), by: (row) => row.source, of: (row) => <Name id={row.source} /> },
          { name: t("cause"), wraps: true, by: (row) => row.code, of: (row) => tell(row.cause) },
          { name: t("takes"), by: lasted, of: (row) => (row.ended ? span(lasted(row)) : t("still")), number: true },
          { name: t("result"), wraps: true, by: (row) => row.outcome, of: (row) => tell(row.outcome) },
          { name: t("acknowledge"), wraps: true, by: (row) => row.acknowledged_by, of: (row) => [row.acknowledged_by, row.note].filter(Boolean).join(": ") },
        ]}
      />
    </div>
  );
}
