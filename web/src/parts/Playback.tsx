/** The plant as it was: the same map at a moment of the past, and how to move through the time that was recorded. */
import { useComputed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { none } from "../known";
import { kept, error, loading, looked, told } from "../past/player";
import { goTo, marks, stepped } from "../past/marks";
import { kindOf } from "../past/reach";
import { room } from "../route";
import { clock, span } from "../shows";
import { alarmCount, layout, recording, type Selection, selected, tick } from "../store";
import { happening, t, tell } from "../texts";
import type { Happening } from "../types";
import { Problem } from "./Problem";
import { serverNow } from "../api";
import { Scrubber } from "./Scrubber";
import { TrackMap } from "./TrackMap";
import { VehicleStrip } from "./VehicleStrip";

export function Playback() {
  return (
    <div class="plan then">
      <VehicleStrip />
      <div class="stage">
        <PastBanner />
        <TrackMap />
      </div>
      <section class="card transport" aria-label={t("playback")}>
        <Problem error={error.value} />
        {kept.value && told.value > 0 ? <Scrubber /> : <p class="nothing">{looked.value ? (kept.value ? t("loading") : t("nothing_recorded")) : t("not_known_yet")}</p>}
      </section>
    </div>
  );
}

/** Day and time of day at this place. */
export function dated(seconds: number): string {
  const at = new Date(seconds * 1000);
  const day = [at.getFullYear(), at.getMonth() + 1, at.getDate()].map((part) => String(part).padStart(2, "0")).join("-");
  return `${day} ${clock(at.toISOString())}`;
}

/** Says that this is the past, for as long as it is, and leads back. */
function PastBanner() {
  void tick.value;
  const incident = kept.value?.incident;
  const at = told.value;
  const ago = Math.max(0, serverNow() / 1000 - at);
  const grave = alarmCount.value;
  return (
    <div class="past-banner" role="status" aria-live="off">
      <b>{t(recording.value ? "past_recording" : "past_here")}</b>
      {at > 0 && <time class="then-at">{dated(at)}</time>}
      {at > 0 && !recording.value && <span>{t("past_ago", span(ago * 1000))}</span>}
      {incident && <span>{t("past_by", incident.by, `${incident.made.slice(0, 10)} ${clock(incident.made)}`)}</span>}
      <span>{t("past_no_commands")}</span>
      {loading.value && <span>{t("loading")}</span>}
      <span class="grow" />
      {grave > 0 && !recording.value && <b class="bad">! {t("past_alarms_now", grave)}</b>}
      {!recording.value && (
        <button type="button" class="primary" onClick={() => (room.value = "map")}>
          {t("back_to_live")}
        </button>
      )}
    </div>
  );
}

/** What to look for in the stretch of time that is drawn; each leads to its moment. */
export function PastEvents() {
  const list = marks.value.toReversed();
  // Drawn anew where the moment passes an event, and not at every moment.
  const ahead = useComputed(() => marks.value.filter((event) => Date.parse(event.ts) / 1000 > told.value).length).value;
  useEffect(() => {
    document.querySelector(`[data-mark="${stepped.value?.seq}"]`)?.scrollIntoView({ block: "nearest" });
  }, [stepped.value]);
  return (
    <section class="card past-events" aria-label={t("events_of_note")}>
      <h2>
        {t("events_of_note")} <small class="calm">{list.length}</small>
      </h2>
      <ol class="scroll" reversed tabIndex={0} aria-label={t("events_of_note")}>
        {list.length === 0 && <li class="nothing">{none(t("no_marks"))}</li>}
        {list.map((event, i) => (
          <Line key={event.seq} event={event} past={i >= ahead} />
        ))}
      </ol>
    </section>
  );
}

/** The drive or device that an event without a vehicle is about, if it is about one. */
function machineOf(id: string | null): Selection {
  const plant = layout.value;
  if (plant?.drives?.some((drive) => drive.id === id)) return { kind: "drive", id: id as string };
  return [...(plant?.doors ?? []), ...(plant?.chargers ?? [])].some((one) => one.id === id) ? { kind: "device", id: id as string } : null;
}

function Line({ event, past }: { event: Happening; past: boolean }) {
  const kind = kindOf(event.event);
  const go = (): void => {
    const machine = machineOf(event.source);
    if (event.vehicle) selected.value = { kind: "vehicle", id: event.vehicle };
    else if (machine) selected.value = machine;
    void goTo(event);
  };
  return (
    <li data-mark={event.seq} class={past ? "" : "ahead"} aria-current={stepped.value?.seq === event.seq ? "true" : undefined}>
      <button type="button" class="text" onClick={go}>
        <i class={`mark ${kind}`} aria-hidden="true" /> <time>{clock(event.ts)}</time> <b>{happening(event.event)}</b>{" "}
        {[event.vehicle, event.source, tell(event.detail || event.result)].filter(Boolean).join(" · ")}
      </button>
    </li>
  );
}
