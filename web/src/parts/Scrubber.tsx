/** Moves through the time that was recorded: play, steps from event to event, a moment by its time, and an incident as a file. */
import { effect, useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { download } from "../api";
import { goTo, iso, marks, reach, readMarks, step, STRETCHES, stretch, type Stretch } from "../past/marks";
import { kept, moment, pace, PACES, pause, play, playing, seek, told } from "../past/player";
import { kindOf, reachOf } from "../past/reach";
import { clock } from "../shows";
import { recording } from "../store";
import { happening, t, type Word } from "../texts";
import { Told, useAsking } from "./asking";
import { Button } from "./Button";
import { dated } from "./Playback";

export function Scrubber() {
  useEffect(() => follow(), []);
  return (
    <>
      <div class="acts-row">
        <Buttons />
        <span class="grow" />
        <Jump />
        <CopyLink />
      </div>
      <Line />
      <Export />
    </>
  );
}

/** Keep the moment within what is drawn, and the marks up to date. */
function follow(): () => void {
  const stops = [
    effect(() => {
      const span = kept.value;
      if (!span || told.value === 0) return;
      const next = reachOf(told.value, span, STRETCHES[stretch.value], reach.peek());
      const { from, to } = reach.peek();
      if (next.from !== from || next.to !== to) reach.value = next;
    }),
    effect(() => {
      if (reach.value.from > 0) void readMarks();
    }),
  ];
  const key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey || (event.target as HTMLElement).closest("input:not([type=range]), select, textarea")) return;
    const does: Record<string, () => void> = { ",": () => void step(-1), ".": () => void step(1), k: toggle };
    if (event.key === " " && !(event.target as HTMLElement).closest("button, a, summary")) does[" "] = toggle;
    if (!does[event.key]) return;
    event.preventDefault();
    does[event.key]?.();
  };
  document.addEventListener("keydown", key);
  return () => {
    for (const stop of stops) stop();
    document.removeEventListener("keydown", key);
  };
}

const toggle = (): void => (playing.value ? pause() : play());

function Buttons() {
  return (
    <>
      <button type="button" title={`${t("event_before")} (,)`} aria-label={t("event_before")} onClick={() => void step(-1)}>
        |◀
      </button>
      <button type="button" class="primary play" title={`${t(playing.value ? "stop_playing" : "play")} (k)`} aria-label={t(playing.value ? "stop_playing" : "play")} onClick={toggle}>
        {playing.value ? "❚❚" : "▶"}
      </button>
      <button type="button" title={`${t("event_next")} (.)`} aria-label={t("event_next")} onClick={() => void step(1)}>
        ▶|
      </button>
      <span class="tabs" role="group" aria-label={t("pace")}>
        {PACES.map((times) => (
          <button type="button" key={times} aria-pressed={pace.value === times} onClick={() => (pace.value = times)}>
            ×{times}
          </button>
        ))}
      </span>
      <select aria-label={t("stretch")} class="narrow" value={stretch.value} onChange={(event) => (stretch.value = event.currentTarget.value as Stretch)}>
        {(Object.keys(STRETCHES) as Stretch[]).map((name) => (
          <option key={name} value={name}>
            {t(`stretch_${name}` as Word)}
          </option>
        ))}
      </select>
    </>
  );
}

/** The moment as a field for day and time has it. */
function local(seconds: number): string {
  return dated(seconds).replace(" ", "T");
}

function Jump() {
  const span = kept.value;
  return (
    <label class="jump">
      <span>{t("moment")}</span>
      <input
        type="datetime-local"
        step="1"
        min={span ? local(span.from) : undefined}
        max={span ? local(span.to) : undefined}
        value={told.value ? local(Math.floor(told.value)) : ""}
        onChange={(event) => {
          const at = Date.parse(event.currentTarget.value) / 1000;
          if (!Number.isNaN(at)) void seek(at);
        }}
      />
    </label>
  );
}

function CopyLink() {
  const done = useSignal(false);
  const copy = async (): Promise<void> => {
    pause();
    await navigator.clipboard?.writeText(location.href).catch(() => undefined);
    done.value = true;
    window.setTimeout(() => (done.value = false), 2000);
  };
  return (
    <button type="button" title={t("link_hint")} onClick={() => void copy()}>
      {t(done.value ? "link_copied" : "link_copy")}
    </button>
  );
}

const cut = { from: 0, to: 0 };

function Line() {
  const { from, to } = reach.value;
  const share = (at: number): string => `${(100 * (at - from)) / (to - from)}%`;
  return (
    <div class="scrubber">
      <Marks />
      <input
        type="range"
        min={Math.floor(from)}
        max={Math.ceil(to)}
        step="1"
        value={told.value}
        aria-label={t("moment")}
        aria-valuetext={dated(told.value)}
        onInput={(event) => void seek(Number(event.currentTarget.value))}
      />
      <div class="ends" aria-hidden="true">
        <span>{dated(from)}</span>
        <span class="here" style={{ left: `clamp(2.4em, ${share(told.value)}, calc(100% - 2.4em))` }}>
          {clock(iso(told.value))}
        </span>
        <span>{dated(to)}</span>
      </div>
    </div>
  );
}

/** Where something happened, by form and colour; the list beside the map says the same in words. */
function Marks() {
  const { from, to } = reach.value;
  return (
    <div class="marks" aria-hidden="true">
      {marks.value.map((event) => {
        const at = (Date.parse(event.ts) / 1000 - from) / (to - from);
        const title = `${clock(event.ts)} ${happening(event.event)} ${event.vehicle ?? event.source ?? ""}`;
        return <i key={event.seq} class={`mark ${kindOf(event.event)}`} style={{ left: `${100 * at}%` }} title={title} onClick={() => void goTo(event)} />;
      })}
    </div>
  );
}

/** From when to when, and the file that `hoistway replay` opens. */
function Export() {
  const from = useSignal(cut.from);
  const to = useSignal(cut.to);
  const asking = useAsking();
  const span = kept.value;
  if (recording.value || !span) return null;
  const begin = from.value || Math.max(span.from, told.value - 300);
  const end = to.value || Math.min(span.to, told.value + 300);
  const field = (label: Word, value: number, set: (at: number) => void) => (
    <>
      <label class="jump">
        <span>{t(label)}</span>
        <input type="datetime-local" step="1" value={local(Math.floor(value))} onChange={(event) => set(Date.parse(event.currentTarget.value) / 1000 || 0)} />
      </label>
      <button type="button" class="plain" title={t("take_moment")} aria-label={`${t(label)} ${t("here")}`} onClick={() => set(moment.value)}>
        {t("here")}
      </button>
    </>
  );
  const save = (): void => {
    const query = new URLSearchParams({ from: iso(begin), to: iso(end) });
    const name = `incident-${iso(begin).slice(0, 19).replaceAll(":", "")}Z.hoistway.gz`;
    void asking.ask(() => download(`/history/export?${query}`, name), t("saved_as", name));
  };
  return (
    <div class="acts-row export" role="group" aria-label={t("incident")}>
      <b>{t("incident")}</b>
      {field("from_moment", begin, (at) => (from.value = cut.from = at))}
      {field("to_moment", end, (at) => (to.value = cut.to = at))}
      <Button needs="GET /history/export" disabled={end <= begin || asking.busy.value} onClick={save}>
        {t("incident_save")} ⤓
      </Button>
      <small class="calm">{t("incident_hint")}</small>
      <Told asking={asking} />
    </div>
  );
}
