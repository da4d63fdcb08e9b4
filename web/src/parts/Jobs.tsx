/** Jobs, newest first: what each does, or why it waits. */
import { useSignal } from "@preact/signals";
import { post, serverNow } from "../api";
import { counted, none } from "../known";
import { told } from "../past/player";
import { elapsed, TONES } from "../shows";
import { ENDED, inPast, jobList, selected, tick, vehicles } from "../store";
import { said, t, tell } from "../texts";
import type { Job } from "../types";
import { Problem } from "./Problem";
import { Sure } from "./Sure";

const SHOWN = 100;
const CANCELLABLE = new Set(["queued", "waiting"]);
const ABORTABLE = new Set(["transferring", "paused"]);

export function Jobs() {
  const which = useSignal<"open" | "ended" | "all">("all");
  const error = useSignal<unknown>(null);
  void tick.value;
  const all = jobList.value;
  const open = all.filter((job) => !ENDED.has(job.state));
  const list = which.value === "open" ? open : which.value === "ended" ? all.filter((job) => ENDED.has(job.state)) : all;
  const ask = (job: Job, what: "cancel" | "abort"): void => {
    error.value = null;
    post(`/jobs/${encodeURIComponent(job.id)}/${what}`).catch((failure: unknown) => (error.value = failure));
  };
  return (
    <section class="card jobs">
      <h2>
        {t("jobs")}
        <span class="tabs">
          {(["all", "open", "ended"] as const).map((tab) => (
            <button type="button" key={tab} aria-pressed={which.value === tab} onClick={() => (which.value = tab)}>
              {t(tab)}
              {tab === "open" && ` ${counted(open.length)}`}
            </button>
          ))}
        </span>
      </h2>
      <Problem error={error.value} />
      <ul class="scroll">
        {list.length === 0 && <li class="nothing">{none(t("no_jobs"))}</li>}
        {list.slice(0, SHOWN).map((job) => (
          <Row key={job.id} job={job} ask={ask} />
        ))}
      </ul>
    </section>
  );
}

function Row({ job, ask }: { job: Job; ask: (job: Job, what: "cancel" | "abort") => void }) {
  const over = ENDED.has(job.state);
  const why = over ? job.result || job.reason : job.reason || leg(job);
  return (
    <li class={over ? "job over" : "job"} data-job={job.id}>
      <span class={`state ${TONES[job.state] ?? "calm"}`}>{said(job.state)}</span>
      <span class="facts">
        <button type="button" class="text" title={t("job_details")} onClick={() => (selected.value = { kind: "job", id: job.id })}>
          {job.id}
        </button>
        {job.priority !== 50 && <span title={t("priority")}>P{job.priority}</span>}
        {job.carrier && <span>{job.carrier}</span>}
        {job.vehicle && (
          <button type="button" class="text" onClick={() => (selected.value = { kind: "vehicle", id: job.vehicle as string })}>
            {job.vehicle}
          </button>
        )}
      </span>
      <span class="age">{elapsed(job, inPast.value ? told.value * 1000 : serverNow())}</span>
      <span class="route">
        <Place id={job.source} />
        <i>→</i>
        <Place id={job.destination} />
      </span>
      <span class="act">
        {!inPast.value && CANCELLABLE.has(job.state) && <Sure needs="POST /jobs/{job}/cancel" label={t("cancel")} does={() => ask(job, "cancel")} />}
        {!inPast.value && ABORTABLE.has(job.state) && <Sure needs="POST /jobs/{job}/abort" label={t("abort")} does={() => ask(job, "abort")} />}
      </span>
      <span class="reason" title={tell(why)}>
        {tell(why)}
      </span>
    </li>
  );
}

function leg(job: Job): string {
  const waiting = job.vehicle ? vehicles.get(job.vehicle)?.waiting : "";
  if (waiting) return waiting;
  if (job.leg === "to_source") return `${job.vehicle} → ${job.source}`;
  if (job.leg === "to_destination") return `${job.vehicle} → ${job.destination}`;
  return job.leg === "none" ? "" : `${job.vehicle}: ${said(job.leg)}`;
}

function Place({ id }: { id: string }) {
  const kind = vehicles.has(id) ? "vehicle" : "station";
  return (
    <button type="button" class="text" onClick={() => (selected.value = { kind, id })}>
      {id}
    </button>
  );
}
