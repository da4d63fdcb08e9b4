/** What is closed, and closing more: a look at what it would do comes first. Track can be chosen on the map above. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { post, serverNow } from "../api";
import { choosing, placed, previewed } from "../closed";
import { clock, span } from "../shows";
import { counted, none } from "../known";
import { closureList, controller, layout, tick } from "../store";
import { said, t, tell } from "../texts";
import type { Closure, ClosurePreview, ZoneNow } from "../types";
import { Choice, Field, Told, useAsking, useRead } from "./asking";
import { Button } from "./Button";
import { ClosedBefore } from "./ClosedBefore";
import { KeptList } from "./Kept";
import { Name } from "./Name";
import { Reasoned } from "./Reasoned";

type Kind = "stretch" | "barcode" | "edge" | "zone" | "station";

export function Closures() {
  void tick.value;
  return (
    <section class="room closing" aria-label={t("closures")}>
      <div class="split">
        <div tabIndex={0} role="group" aria-label={t("closures")}>
          <h2 class="sub" title={t("closures_title")}>
            {t("closures_by_people")} {counted(closureList.value.length)}
          </h2>
          {closureList.value.length === 0 && <p class="nothing">{none(t("nothing_closed"))}</p>}
          <ul class="alarms">
            {closureList.value.map((closure) => (
              <Line key={closure.id} closure={closure} />
            ))}
          </ul>
          <KeptList />
          <Zones />
          <ClosedBefore />
        </div>
        <Close />
      </div>
    </section>
  );
}

function Line({ closure }: { closure: Closure }) {
  const left = closure.expires ? Date.parse(closure.expires) - serverNow() : null;
  return (
    <li data-closure={closure.id}>
      <span class={`sign ${closure.state === "draining" ? "wait" : ""}`}>{closure.state === "draining" ? "…" : "✕"}</span>
      <span>
        <b>{placed(closure.place)}</b> · {said(closure.state)} · {said(closure.purpose)}: {closure.reason}
      </span>
      <p class="remedy">
        {closure.owner} · {t("since", clock(closure.since))}
        {left !== null && ` · ${t("ends_in", span(left))}`}
        {closure.releases.length > 0 && ` · ${t("release_wished", closure.releases.join(", "))}`}
      </p>
      {closure.waiting.map((words) => (
        <p key={words} class="wait">
          {tell(words)}
        </p>
      ))}
      <div class="wide">
        <Reasoned decisions={[{ label: t("open_it"), needs: "POST /closures/{closure}/open", bare: true, grave: true, does: () => post(`/closures/${closure.id}/open`, {}) }]} />
      </div>
    </li>
  );
}

/** Zones of the plant: paused, stopped, resumed. */
function Zones() {
  const { value } = useRead<{ items: ZoneNow[] }>("/zones", controller.value?.pauses, Math.floor(tick.value / 3));
  if (!value?.items.length) return null;
  return (
    <>
      <h2 class="sub">{t("layer_zones")}</h2>
      <ul class="alarms zones">
        {value.items.map((zone) => (
          <li key={zone.id} data-zone={zone.id}>
            <span class="sign wait">{zone.state === "auto" ? "" : "‖"}</span>
            <span>
              <b>{tell(zone.name) || zone.id}</b> · {said(zone.state)} · {zone.vehicles.length} / {zone.capacity}{" "}
              {zone.vehicles.map((id) => (
                <span key={id}>
                  <Name id={id} />{" "}
                </span>
              ))}
            </span>
            {zone.pause && (
              <p class="remedy">
                {zone.pause.owner}: {zone.pause.reason}
              </p>
            )}
            <details>
              <summary>{t("change")}</summary>
              <Reasoned
                decisions={[
                  { label: t("pause"), needs: "POST /zones/{zone}/pause", does: (reason) => post(`/zones/${encodeURIComponent(zone.id)}/pause`, { reason }) },
                  { label: t("stop_zone"), needs: "POST /zones/{zone}/stop", grave: true, does: (reason) => post(`/zones/${encodeURIComponent(zone.id)}/stop`, { reason }) },
                  { label: t("resume"), needs: "POST /zones/{zone}/resume", bare: true, does: () => post(`/zones/${encodeURIComponent(zone.id)}/resume`) },
                ]}
              />
            </details>
          </li>
        ))}
      </ul>
    </>
  );
}

function Close() {
  const kind = useSignal<Kind>("stretch");
  const from = useSignal("");
  const to = useSignal("");
  const purpose = useSignal<"traffic" | "work">("traffic");
  const minutes = useSignal("");
  const reason = useSignal("");
  const preview = useSignal<ClosurePreview | null>(null);
  const asking = useAsking();
  const two = kind.value === "stretch" || kind.value === "edge";
  useEffect(() => {
    // A click on the track fills what is still empty, else begins anew.
    choosing.value = (barcode) => {
      if (kind.value === "zone" || kind.value === "station") return;
      if (!from.value || (two && to.value) || !two) [from.value, to.value] = [barcode, ""];
      else to.value = barcode;
    };
    return () => {
      choosing.value = null;
      previewed.value = [];
    };
  }, [two]);
  useEffect(() => {
    // What was looked at is another place now.
    preview.value = null;
    previewed.value = [];
  }, [kind.value, from.value, to.value]);
  const place = (): object => {
    const [a, b] = [from.value.trim(), to.value.trim()];
    if (kind.value === "stretch" || kind.value === "edge") return { kind: kind.value, from: a, to: b };
    if (kind.value === "zone") return { kind: "zone", zone: a };
    return kind.value === "station" ? { kind: "station", station: a } : { kind: "barcode", barcodes: a.split(/[\s,]+/) };
  };
  const look = async (): Promise<void> => {
    preview.value = null;
    await asking.ask(async () => {
      preview.value = await post<ClosurePreview>("/closures/preview", { place: place() });
      previewed.value = preview.value.barcodes;
    }, "");
  };
  const close = async (): Promise<void> => {
    const body = { place: place(), reason: reason.value.trim(), purpose: purpose.value, ...(minutes.value ? { minutes: Number(minutes.value) } : {}) };
    if (!(await asking.ask(() => post("/closures", body), t("closes_now")))) return;
    [preview.value, previewed.value, reason.value] = [null, [], ""];
  };
  const whole = Boolean(from.value.trim() && (!two || to.value.trim()));
  return (
    <form
      class="stack padded"
      aria-label={t("close_place")}
      onSubmit={(event) => {
        event.preventDefault();
        void (preview.value ? close() : look());
      }}
    >
      <h2 class="sub">{t("close_place")}</h2>
      <div class="fields">
        <Choice
          label={t("kind")}
          value={kind}
          of={[
            ["stretch", t("close_stretch")],
            ["edge", t("close_edge")],
            ["barcode", t("close_barcode")],
            ["zone", t("close_zone")],
            ["station", t("at_station")],
          ]}
        />
        <Field label={two ? t("close_from") : t("name")} name="from" value={from} list={kind.value === "zone" ? "zone-names" : "place-names"} />
        {two && <Field label={t("close_to")} name="to" value={to} />}
        <Choice
          label={t("purpose")}
          value={purpose}
          of={[
            ["traffic", t("traffic")],
            ["work", t("work")],
          ]}
        />
        {purpose.value === "traffic" && <Field label={t("minutes")} name="minutes" type="number" min={1} value={minutes} hint={t("until_opened")} />}
        <Field label={t("reason")} name="reason" value={reason} wide />
      </div>
      <datalist id="zone-names">{layout.value?.zones.map(({ id }) => <option key={id} value={id} />)}</datalist>
      <datalist id="place-names">
        {kind.value === "station" && layout.value?.stations.map(({ id }) => <option key={id} value={id} />)}
      </datalist>
      <p class="calm">{t(kind.value === "station" || kind.value === "zone" ? "look_first" : "choose_on_map")}</p>
      <div class="acts-row">
        <button type="button" disabled={!whole} onClick={() => void look()}>
          {t("preview")}
        </button>
        <Button needs="POST /closures" type="submit" class="halt" disabled={!whole || !reason.value.trim() || !preview.value}>
          {t("close_place")}
        </Button>
      </div>
      <Told asking={asking} />
      {preview.value && <Effects preview={preview.value} />}
    </form>
  );
}

/** The jobs that a closure would touch, each with why; the server names the first of them. */
function Jobs({ touched, jobs }: { touched: number; jobs: ClosurePreview["jobs"] }) {
  return (
    <>
      <b>{t("jobs_touched", touched)}</b>
      <ul class="plain" aria-label={t("jobs_touched", touched)}>
        {jobs.map(({ job, why }) => (
          <li key={job}>
            <Name id={job} />: {tell(why)}
          </li>
        ))}
      </ul>
      {touched > jobs.length && <small class="calm">{t("and_more", touched - jobs.length)}</small>}
    </>
  );
}

function Effects({ preview }: { preview: ClosurePreview }) {
  const { routes } = preview;
  const names = (label: string, list: string[]) =>
    list.length > 0 && (
      <p>
        <b>{label}</b>{" "}
        {list.slice(0, 30).map((id) => (
          <span key={id}>
            <Name id={id} />{" "}
          </span>
        ))}
        {list.length > 30 && t("more_rows", list.length - 30)}
      </p>
    );
  return (
    <div class="note stack" data-preview>
      <b>{placed(preview.place)}</b>
      {names(t("stations_closed"), preview.stations)}
      {names(t("cut_off"), preview.cut_off)}
      {names(t("drive_out"), preview.inside)}
      {names(t("shut_in"), preview.shut_in)}
      {preview.jobs_touched > 0 && <Jobs touched={preview.jobs_touched} jobs={preview.jobs} />}
      <p>
        {preview.jobs_touched === 0 && `${t("jobs_touched", 0)} · `}
        {t("routes_longer", routes.longer, routes.compared)} · {t("routes_lost", routes.lost)}
      </p>
      <p>{t("routes_mean", routes.mean_seconds.toFixed(1), routes.mean_seconds_after.toFixed(1))}</p>
      {routes.worst.slice(0, 3).map((one) => (
        <p key={one.from + one.to} class="calm">
          {one.from} → {one.to}: {one.seconds.toFixed(0)} → {one.seconds_after.toFixed(0)} s
        </p>
      ))}
    </div>
  );
}

