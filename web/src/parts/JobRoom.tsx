/** All jobs in a table: open ones live, ended ones from the history, older ones on demand. */
import { useSignal } from "@preact/signals";
import { get, serverNow } from "../api";
import { counted } from "../known";
import { clock, elapsed, TONES } from "../shows";
import { ENDED, jobList, selected, tick } from "../store";
import { said, t, tell } from "../texts";
import type { Job } from "../types";
import { Name } from "./Name";
import { Problem } from "./Problem";
import { Table } from "./Table";

const PAGE = 200;
const STATES = ["queued", "waiting", "transferring", "paused", "cancelling", "aborting", "completed", "failed", "cancelled", "aborted"];

export function JobRoom() {
  const letters = useSignal("");
  const state = useSignal("");
  const older = useSignal<Job[]>([]);
  const error = useSignal<unknown>(null);
  void tick.value;
  const known = new Set(jobList.value.map((job) => job.id));
  const all = [...jobList.value, ...older.value.filter((job) => !known.has(job.id))];
  const wanted = letters.value.trim().toLowerCase();
  const hits = (job: Job): boolean =>
    [job.id, job.source, job.destination, job.carrier, job.vehicle, job.actor].some((name) => name?.toLowerCase().includes(wanted) ?? false);
  const rows = all.filter((job) => (!state.value || (state.value === "open" ? !ENDED.has(job.state) : job.state === state.value)) && hits(job));
  const more = async (): Promise<void> => {
    error.value = null;
    const oldest = all.filter((job) => ENDED.has(job.state)).reduce((least, job) => Math.min(least, job.order), Number.MAX_SAFE_INTEGER);
    try {
      const { items } = await get<{ items: Job[] }>(`/jobs?limit=${PAGE}&after=${oldest}`);
      older.value = [...older.value, ...items.filter((job) => ENDED.has(job.state))];
    } catch (failure) {
      error.value = failure;
    }
  };
  return (
    <section class="room" aria-label={t("jobs")}>
      <div class="head">
        <h2>
          {t("jobs")} {counted(rows.length)}
        </h2>
        <Problem error={error.value} />
        <button type="button" onClick={() => void more()}>
          {t("older")}
        </button>
        <select aria-label={t("state")} value={state.value} onChange={(event) => (state.value = event.currentTarget.value)}>
          <option value="">{t("all")}</option>
          <option value="open">{t("open")}</option>
          {STATES.map((name) => (
            <option key={name} value={name}>
              {said(name)}
            </option>
          ))}
        </select>
        <input type="search" aria-label={t("filter")} placeholder={t("filter")} value={letters.value} onInput={(event) => (letters.value = event.currentTarget.value)} />
      </div>
      <Table
        label={t("jobs")}
        rows={rows}
        keyOf={(job) => job.id}
        pick={({ id }) => (selected.value = { kind: "job", id })}
        chosen={selected.value?.kind === "job" ? selected.value.id : null}
        none={t(all.length ? "no_match" : "no_jobs")}
        columns={[
          {
            name: t("job"),
            by: (job) => job.order,
            of: ({ id }) => (
              <button type="button" class="text" onClick={() => (selected.value = { kind: "job", id })}>
                {id}
              </button>
            ),
          },
          { name: t("state"), by: (job) => said(job.state), of: (job) => <span class={`state ${TONES[job.state] ?? "calm"}`}>{said(job.state)}</span> },
          { name: t("priority"), by: (job) => job.priority, of: (job) => job.priority, number: true },
          { name: t("source"), by: (job) => job.source, of: (job) => <Name id={job.source} /> },
          { name: t("destination"), by: (job) => job.destination, of: (job) => <Name id={job.destination} /> },
          { name: t("carrier"), by: (job) => job.carrier, of: (job) => job.carrier ?? "" },
          { name: t("vehicle"), by: (job) => job.vehicle, of: (job) => <Name id={job.vehicle} /> },
          { name: t("ordered_at"), by: (job) => job.created, of: (job) => clock(job.created) },
          { name: t("takes"), by: (job) => took(job), of: (job) => elapsed(job, serverNow()), number: true },
          { name: t("why"), wraps: true, of: (job) => tell(ENDED.has(job.state) ? job.result || job.reason : job.reason) },
        ]}
      />
    </section>
  );
}

function took(job: Job): number {
  return (job.ended ? Date.parse(job.ended) : serverNow()) - Date.parse(job.created);
}
