/** One job: its phases, why this vehicle, what it waited for, its events, and all that can be done about it. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { call, get, post, serverNow } from "../api";
import { lastTakenBack, phasesOf } from "../phases";
import { clock, TONES } from "../shows";
import { changes, ENDED, jobList, layout, tick } from "../store";
import { happening, said, t, tell } from "../texts";
import type { Assignment, Happening, Job, JobWhy } from "../types";
import { Button } from "./Button";
import { CutOff } from "./Kept";
import { Name } from "./Name";
import { Fact, Panel } from "./Panel";
import { Problem } from "./Problem";
import { Sure } from "./Sure";

const COLOURS = { calm: "var(--dim)", go: "var(--accent)", wait: "var(--wait)", good: "var(--good)", bad: "var(--bad)" };
const EVERY = 3;

export function JobPanel({ id }: { id: string }) {
  const why = useSignal<JobWhy | null>(null);
  const whole = useSignal<(Job & { history: Happening[] }) | null>(null);
  const error = useSignal<unknown>(null);
  const live = jobList.value.find((job) => job.id === id);
  const job = live ?? whole.value;
  const over = job ? ENDED.has(job.state) : false;
  const round = over ? 0 : Math.floor(tick.value / EVERY);
  useEffect(() => {
    const path = `/jobs/${encodeURIComponent(id)}`;
    get<JobWhy>(`${path}/why`).then(
      (found) => (why.value = found),
      (failure: unknown) => (error.value = failure),
    );
    get<Job & { history: Happening[] }>(path).then(
      (found) => (whole.value = found),
      (failure: unknown) => (error.value = failure),
    );
  }, [id, job?.state, job?.vehicle, round]);
  if (!job) return <Panel title={id} tag={t("job")} colour="var(--dim)"><Problem error={error.value} /></Panel>;
  const tone = TONES[job.state] ?? "calm";
  const before = job.vehicle ? null : whole.value?.history[lastTakenBack(whole.value.history, over)]?.vehicle;
  return (
    <Panel title={job.id} tag={said(job.state)} colour={COLOURS[tone]}>
      {job.reason && !over && (
        <p class="note waits">
          <b>{t("waits")}</b> {tell(job.reason)}
        </p>
      )}
      {!over && <CutOff id={job.source} />}
      {!over && <CutOff id={job.destination} />}
      <dl>
        <Fact name={t("source")}>
          <Name id={job.source} />
        </Fact>
        <Fact name={t("destination")}>
          <Name id={job.destination} />
          {job.fallbacks.length > 0 && <small> · {t("fallbacks", job.fallbacks.join(", "))}</small>}
        </Fact>
        <Fact name={t("carrier")}>{job.carrier ?? t("unknown")}</Fact>
        <Fact name={t("vehicle")}>
          {job.vehicle ? <Name id={job.vehicle} /> : t("none")}
          {before && (
            <small>
              {" "}
              · {t("had_before")} <Name id={before} />
            </small>
          )}
          {job.wish && <small> · {t("wished", job.wish)}</small>}
        </Fact>
        <Fact name={t("priority")}>{job.priority}</Fact>
        <Fact name={t("ordered_by")}>
          {job.actor} <small>· {clock(job.created)}</small>
        </Fact>
        {over && <Fact name={t("result")}>{tell(job.result || job.reason) || said(job.state)}</Fact>}
      </dl>
      {whole.value && <Phases job={job} events={whole.value.history} />}
      {!over && <Change job={job} />}
      {why.value && <Why why={why.value} events={whole.value?.history ?? []} over={over} />}
      {whole.value && <History events={whole.value.history} />}
      <Problem error={error.value} />
    </Panel>
  );
}

const seconds = (value: number): string => (value >= 100 ? `${Math.round(value)} s` : `${value.toFixed(1)} s`);

/** How long it lay, was fetched, picked up, carried and put down: drawn to scale. */
function Phases({ job, events }: { job: Job; events: Happening[] }) {
  const phases = phasesOf(job.created, ENDED.has(job.state) ? null : serverNow(), events);
  if (phases.length === 0) return null;
  return (
    <section class="part">
      <h3>{t("phases")}</h3>
      <div class="phases">
        {phases.map(({ name, took }) => (
          <span key={name} class={name} style={{ flex: `${Math.max(took, 0.01)} 1 0` }} title={`${t(`phase_${name}`)} ${seconds(took)}`}>
            {seconds(took)}
          </span>
        ))}
      </div>
      <small class="calm">{phases.map(({ name, took }) => `${t(`phase_${name}`)} ${seconds(took)}`).join(" · ")}</small>
    </section>
  );
}

function Why({ why, events, over }: { why: JobWhy; events: Happening[]; over: boolean }) {
  return (
    <>
      <section class="part why-list">
        <h3>{t("why_vehicle")}</h3>
        {why.assignments.length === 0 && <p class="nothing">{t("not_assigned_yet")}</p>}
        {why.assignments.map((choice) => (
          <Choice key={choice.at + choice.vehicle} choice={choice} until={takenBack(choice, events.slice(0, lastTakenBack(events, over) + 1))} />
        ))}
      </section>
      <section class="part why-list">
        <h3>{t("why_waits")}</h3>
        {why.waits.length === 0 && <p class="nothing">{t("never_waited")}</p>}
        <table>
          <tbody>
            {why.waits.map((wait) => (
              <tr key={wait.since + wait.reason}>
                <td>{clock(wait.since)}</td>
                <td>{wait.seconds === null ? t("still") : seconds(wait.seconds)}</td>
                <td>{tell(wait.reason)}</td>
              </tr>
            ))}
          </tbody>
        </table>
        {why.left_out > 0 && <small class="calm">{t("left_out", why.left_out)}</small>}
      </section>
    </>
  );
}

/** When a vehicle lost the job that it was given, by the events up to when the job was last taken back; null: it did not. */
function takenBack({ vehicle, at }: Assignment, events: Happening[]): string | null {
  return events.find((event) => event.event === "VehicleUnassigned" && event.vehicle === vehicle && event.ts >= at)?.ts ?? null;
}

function Choice({ choice, until }: { choice: Assignment; until: string | null }) {
  return (
    <div class="choice">
      <b>
        <Name id={choice.vehicle} /> · {t("to_source", seconds(choice.seconds))}
      </b>{" "}
      <small class="calm">{clock(choice.at)}</small>
      {until && <p class="wait">{t("taken_back", clock(until))}</p>}
      <div>
        {choice.hot && `${t("hot_lot")} · `}
        {choice.before && choice.saved !== null && `${t("instead_of", choice.before, seconds(choice.saved))} · `}
        {t("worth", seconds(choice.waited), seconds(choice.switch))}
      </div>
      {choice.candidates.length > 0 && (
        <table>
          <tbody>
            {choice.candidates.map((other) => (
              <tr key={other.vehicle}>
                <td>
                  <Name id={other.vehicle} />
                </td>
                <td>{other.seconds === null ? t("no_way") : seconds(other.seconds)}</td>
                <td>{tell(other.why_not)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </div>
  );
}

function History({ events }: { events: Happening[] }) {
  return (
    <details class="part">
      <summary>
        {t("events")} {events.length}
      </summary>
      <table class="bits">
        <tbody>
          {events.map((event) => (
            <tr key={event.seq}>
              <th>{clock(event.ts)}</th>
              <td>#{event.seq}</td>
              <td>
                {happening(event.event)} {[event.vehicle, event.result && said(event.result), event.detail !== event.result && tell(event.detail)].filter(Boolean).join(" · ")}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </details>
  );
}

const CANCELLABLE = new Set(["queued", "waiting"]);
const ABORTABLE = new Set(["transferring", "paused"]);

/** Other priority, destination or vehicle; or its end. */
function Change({ job }: { job: Job }) {
  const error = useSignal<unknown>(null);
  const done = useSignal(false);
  const priority = useSignal(String(job.priority));
  const destination = useSignal(job.destination);
  const vehicle = useSignal(job.wish ?? "");
  const reason = useSignal("");
  void changes.stations.value;
  const path = `/jobs/${encodeURIComponent(job.id)}`;
  const taken = !CANCELLABLE.has(job.state);
  const report = (asked: Promise<unknown>): void => {
    error.value = null;
    done.value = false;
    asked.then(
      () => (done.value = true),
      (failure: unknown) => (error.value = failure),
    );
  };
  const body = {
    ...(Number(priority.value) !== job.priority ? { priority: Number(priority.value) } : {}),
    ...(destination.value !== job.destination ? { destination: destination.value } : {}),
    ...(vehicle.value !== (job.wish ?? "") ? { vehicle: vehicle.value || null } : {}),
  };
  const end = (how: "cancel" | "abort"): void => report(post(`${path}/${how}`, { reason: reason.value.trim() }));
  return (
    <form
      class="part"
      onSubmit={(event) => {
        event.preventDefault();
        report(call("PATCH", path, body));
      }}
    >
      <h3>{t("change")}</h3>
      <div class="fields">
        <label>
          <span>{t("priority")}</span>
          <input name="priority" type="number" min="0" max="99" required value={priority.value} onInput={(event) => (priority.value = event.currentTarget.value)} />
        </label>
        <label>
          <span>{t("vehicle")}</span>
          <input name="vehicle" disabled={taken} title={taken ? t("against_other_vehicle", job.vehicle ?? "") : ""} list="vehicle-names" autocomplete="off" placeholder={t("any")} value={vehicle.value} onInput={(event) => (vehicle.value = event.currentTarget.value.trim())} />
        </label>
        <label class="wide">
          <span>{t("destination")}</span>
          <input name="destination" list="station-names" autocomplete="off" required value={destination.value} onInput={(event) => (destination.value = event.currentTarget.value.trim())} />
        </label>
      </div>
      {(CANCELLABLE.has(job.state) || ABORTABLE.has(job.state)) && (
        <div class="fields">
          <label class="wide">
            <span>{t("reason_of_end")}</span>
            <input name="reason" maxLength={200} autocomplete="off" placeholder={t("may_be_empty")} value={reason.value} onInput={(event) => (reason.value = event.currentTarget.value)} />
          </label>
        </div>
      )}
      <datalist id="vehicle-names">
        {layout.value?.vehicles.map(({ id }) => <option key={id} value={id} />)}
      </datalist>
      <datalist id="station-names">
        {layout.value?.stations.map(({ id }) => <option key={id} value={id} />)}
      </datalist>
      <div class="acts-row">
        <Button needs="PATCH /jobs/{job}" type="submit" class="primary" disabled={Object.keys(body).length === 0}>
          {t("change")}
        </Button>
        {CANCELLABLE.has(job.state) && <Sure needs="POST /jobs/{job}/cancel" label={t("cancel")} does={() => end("cancel")} />}
        {ABORTABLE.has(job.state) && <Sure needs="POST /jobs/{job}/abort" label={t("abort")} does={() => end("abort")} />}
        {done.value && <span class="done" role="status">{t("taken")}</span>}
      </div>
      <Problem error={error.value} />
    </form>
  );
}
