/** What a period came to: delivery times by phase, throughput, queue, vehicles, what was waited for; as files, and to print. */
import { useSignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { bytes, download, serverNow } from "../api";
import { span } from "../shows";
import { selected, tick } from "../store";
import { language, said, t, tell, type Word } from "../texts";
import type { LateShown, StatisticsShown, TimesShown } from "../types";
import { Field, Told, useAsking, useRead } from "./asking";
import { Chart } from "./Chart";
import { Name } from "./Name";
import { Problem } from "./Problem";
import { Table } from "./Table";

const PERIODS = { hour: [3600, 60], shift: [8 * 3600, 900], day: [86_400, 3600], week: [7 * 86_400, 6 * 3600] } as const;
/** A period of one's own has so many intervals, none shorter than a minute. */
const INTERVALS = 60;
type Period = keyof typeof PERIODS | "other";
const KINDS = ["csv", "parquet"] as const;
const PHASES = ["queued", "fetching", "acquiring", "carrying", "depositing", "total"] as const;
const TABLES = ["phases", "intervals", "vehicles", "waits", "places", "late", "open", "transfers"] as const;
/** Read anew so often, s. */
const EVERY = 60;

export function Statistics() {
  const period = useSignal<Period>("hour");
  const round = Math.floor(tick.value / EVERY);
  const kind = useSignal<(typeof KINDS)[number]>("csv");
  const own = { begin: useSignal(""), end: useSignal("") };
  const asked = period.value === "other" ? [own.begin.value, own.end.value] : [round];
  const query = useMemo(() => queryOf(period.value, own.begin.value, own.end.value), [period.value, ...asked]);
  const { value, error } = useRead<StatisticsShown>(query && `/statistics?${query}`);
  const asking = useAsking();
  const save = (path: string, name: string): void => void asking.ask(() => download(path, name), "");
  return (
    <section class="room" aria-label={t("statistics")}>
      <div class="head">
        <h2>{t("statistics")}</h2>
        <span class="tabs">
          {[...(Object.keys(PERIODS) as Period[]), "other" as const].map((name) => (
            <button type="button" key={name} aria-pressed={period.value === name} onClick={() => (period.value = name)}>
              {t(`period_${name}` as Word)}
            </button>
          ))}
        </span>
        {period.value === "other" && (
          <span class="own">
            <Field label={t("period_begin")} name="begin" type="datetime-local" value={own.begin} />
            <Field label={t("period_end")} name="end" type="datetime-local" value={own.end} />
          </span>
        )}
        <select aria-label={t("file_kind")} value={kind.value} onChange={(event) => (kind.value = event.currentTarget.value as "csv")}>
          {KINDS.map((name) => (
            <option key={name} value={name}>
              {name === "csv" ? "CSV" : "Parquet"}
            </option>
          ))}
        </select>
        {TABLES.map((table) => (
          <button
            type="button"
            key={table}
            disabled={query === null}
            onClick={() => save(`/statistics/${table}.${kind.value}?${query}`, `${table}.${kind.value}`)}
          >
            {t(`table_${table}` as Word)} ⤓
          </button>
        ))}
        <button type="button" disabled={query === null} onClick={() => save(reportOf(query), "report.html")}>
          {t("report")} ⤓
        </button>
        <button type="button" disabled={query === null} title={t("print_report")} onClick={() => void asking.ask(() => print(reportOf(query)), "")}>
          {t("print")}
        </button>
        <Told asking={asking} />
        <Problem error={error} />
      </div>
      <div class="scroll figures" tabIndex={0} role="group" aria-label={t("statistics")}>
        {value && <Shown found={value} />}
      </div>
    </section>
  );
}

/** What is asked for; null: a period of one's own that is not whole yet. */
function queryOf(period: Period, begin: string, end: string): URLSearchParams | null {
  const of = (from: number, to: number, interval: number): URLSearchParams =>
    new URLSearchParams({ from: new Date(from).toISOString(), to: new Date(to).toISOString(), interval: String(interval) });
  if (period !== "other") {
    const [length, interval] = PERIODS[period];
    const now = serverNow();
    return of(now - length * 1000, now, interval);
  }
  const [from, to] = [Date.parse(begin), Date.parse(end)];
  if (!(from < to)) return null;
  return of(from, to, Math.max(60, Math.ceil((to - from) / 1000 / INTERVALS)));
}

/** The report in the language of the page and the time of this browser. */
function reportOf(query: URLSearchParams | null): string {
  const zone = Intl.DateTimeFormat().resolvedOptions().timeZone;
  return `/statistics/report?${query}&lang=${language.value}${zone ? `&tz=${encodeURIComponent(zone)}` : ""}`;
}

/** Open a page of the server by itself, and its print dialog. A link could not carry the access key. */
async function print(path: string): Promise<void> {
  const page = URL.createObjectURL(new Blob([await bytes(path)], { type: "text/html" }));
  const opened = window.open(page);
  opened?.addEventListener("load", () => opened.print());
}

const seconds = (value: number | null): string => (value === null ? "–" : value < 100 ? `${value.toFixed(1)} s` : span(value * 1000));

function Shown({ found }: { found: StatisticsShown }) {
  const times = useMemo(() => found.intervals.map((one) => Date.parse(one.begin) / 1000), [found]);
  const through = useMemo(
    () => [
      { label: t("completed"), colour: "--look-charging", values: found.intervals.map((one) => one.completed), bars: true },
      { label: t("jobs_ordered"), colour: "--look-moving", values: found.intervals.map((one) => one.ordered) },
      { label: t("queue"), colour: "--look-waiting", values: found.intervals.map((one) => one.queue) },
    ],
    [found, language.value],
  );
  const delivery = useMemo(
    () => [
      { label: "p50", colour: "--look-moving", values: found.intervals.map((one) => one.delivery.p50) },
      { label: "p95", colour: "--look-held", values: found.intervals.map((one) => one.delivery.p95) },
    ],
    [found],
  );
  const most = Math.max(1, ...found.waits.map((one) => one.seconds));
  return (
    <>
      <p class="tiles">
        {Object.entries(found.jobs).map(([state, count]) => (
          <span key={state}>
            <b>{count}</b> {said(state)}
          </span>
        ))}
        <span>
          <b>{found.empty_share === null ? "–" : `${Math.round(found.empty_share * 100)} %`}</b> {t("empty_travel")}
        </span>
      </p>
      <Chart label={t("throughput")} times={times} lines={through} unit={t("jobs")} />
      <Chart label={t("delivery_time")} times={times} lines={delivery} unit={t("seconds_unit")} />
      <Phases phases={found.phases} />
      <h3>{t("waits_by_cause")}</h3>
      <table class="list">
        <tbody>
          {found.waits.map((one) => (
            <tr key={one.cause}>
              <td>{tell(said(one.cause))}</td>
              <td class="number">{one.times}</td>
              <td class="number">{span(one.seconds * 1000)}</td>
              <td class="bar">
                <i style={{ width: `${(100 * one.seconds) / most}%` }} />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      {found.waits.length === 0 && <p class="nothing">{t("never_waited")}</p>}
      <Lateness found={found} />
      <h3>{t("vehicles")}</h3>
      <Table
        label={t("vehicles")}
        rows={found.vehicles}
        keyOf={(row) => row.vehicle}
        none={t("nothing_found")}
        columns={[
          { name: t("vehicle"), by: (row) => row.vehicle, of: (row) => <Name id={row.vehicle} /> },
          { name: t("completed"), by: (row) => row.completed, of: (row) => row.completed, number: true },
          { name: t("utilisation"), by: (row) => row.busy_share, of: (row) => `${(row.busy_share * 100).toFixed(1)} %`, number: true },
          { name: t("failures"), by: (row) => row.failures, of: (row) => row.failures, number: true },
          { name: t("mtbf_hours"), by: (row) => row.mtbf_hours, of: (row) => row.mtbf_hours ?? "–", number: true },
          { name: t("mttr_minutes"), by: (row) => row.mttr_minutes, of: (row) => row.mttr_minutes ?? "–", number: true },
          { name: t("availability"), by: (row) => row.availability, of: (row) => `${(row.availability * 100).toFixed(2)} %`, number: true },
        ]}
      />
    </>
  );
}

/** Why lots were late: where jobs waited, the latest by name, and what is still open. */
function Lateness({ found }: { found: StatisticsShown }) {
  const reason = (row: { reason: string }): string => tell(said(row.reason));
  const pick = (row: { job: string }): void => void (selected.value = { kind: "job", id: row.job });
  return (
    <>
      <h3>{t("waits_by_place")}</h3>
      <Table
        label={t("waits_by_place")}
        rows={found.places}
        keyOf={(row) => row.place}
        none={t("nothing_found")}
        columns={[
          { name: t("place"), by: (row) => row.place, of: (row) => <Name id={row.place} /> },
          { name: t("jobs"), by: (row) => row.jobs, of: (row) => row.jobs, number: true },
          { name: t("waits"), by: (row) => row.seconds, of: (row) => seconds(row.seconds), number: true },
          { name: t("cause"), by: (row) => row.cause, of: (row) => tell(said(row.cause)), wraps: true },
        ]}
      />
      <h3>{t("late_lots")}</h3>
      <Table
        label={t("late_lots")}
        rows={found.late}
        keyOf={(row) => row.job}
        pick={pick}
        none={t("nothing_found")}
        columns={[
          { name: t("job"), by: (row) => row.job, of: (row) => row.job },
          { name: t("source"), by: (row) => row.source, of: (row) => row.source },
          { name: t("destination"), by: (row) => row.destination, of: (row) => row.destination },
          ...PHASES.map((phase) => ({
            name: t(`phase_${phase}`),
            by: (row: LateShown) => row[phase],
            of: (row: LateShown) => seconds(row[phase]),
            number: true,
          })),
          { name: t("longest_wait"), by: (row) => row.waited, of: (row) => seconds(row.waited), number: true },
          { name: t("waited_for"), by: reason, of: reason, wraps: true },
        ]}
      />
      <h3>{t("open_at_end")}</h3>
      <Table
        label={t("open_at_end")}
        rows={found.open}
        keyOf={(row) => row.job}
        pick={pick}
        none={t("nothing_found")}
        columns={[
          { name: t("job"), by: (row) => row.job, of: (row) => row.job },
          { name: t("source"), by: (row) => row.source, of: (row) => row.source },
          { name: t("destination"), by: (row) => row.destination, of: (row) => row.destination },
          { name: t("age"), by: (row) => row.seconds, of: (row) => seconds(row.seconds), number: true },
          { name: t("waited_for"), by: reason, of: reason, wraps: true },
        ]}
      />
    </>
  );
}

function Phases({ phases }: { phases: Record<string, TimesShown> }) {
  return (
    <>
      <h3>{t("phases")}</h3>
      <table class="list">
        <thead>
          <tr>
            {[t("phase"), t("count"), t("mean"), "p50", "p95", t("longest")].map((name) => (
              <th key={name}>
                <span>{name}</span>
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {PHASES.filter((name) => phases[name]).map((name) => {
            const { count, mean, p50, p95, longest } = phases[name] as TimesShown;
            return (
              <tr key={name} data-phase={name}>
                <td>{t(`phase_${name}` as Word)}</td>
                <td>{count}</td>
                {[mean, p50, p95, longest].map((value, i) => (
                  <td key={i}>{seconds(value)}</td>
                ))}
              </tr>
            );
          })}
        </tbody>
      </table>
    </>
  );
}
