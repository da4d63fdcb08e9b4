/** The form that orders a transfer. */
import { useSignal } from "@preact/signals";
import { freshKey, post, Refused } from "../api";
import { worldOf, worldOfKind } from "../ends";
import { changes, layout, order, orderFrom, orderTo, stations, vehicleList } from "../store";
import { t } from "../texts";
import type { Job } from "../types";
import { Field } from "./asking";
import { Button } from "./Button";
import { Problem } from "./Problem";

let key = freshKey();
let written = "";

/** The same order keeps its key, so that sending it again after a lost answer makes no second job. */
function keyOf(body: unknown): string {
  const now = JSON.stringify(body);
  if (now !== written) key = freshKey();
  written = now;
  return key;
}

export function Transfer() {
  const priority = useSignal("50");
  const wish = useSignal("");
  const fallbacks = useSignal("");
  const name = useSignal("");
  const sending = useSignal(false);
  const error = useSignal<unknown>(null);
  const done = useSignal("");
  void changes.stations.value;
  const known = stations.get(order.source.value)?.carrier ?? "";

  const send = async (event: Event): Promise<void> => {
    event.preventDefault();
    const body = {
      source: order.source.value,
      destination: order.destination.value,
      priority: Number(priority.value),
      ...(order.carrier.value.trim() ? { carrier: order.carrier.value.trim() } : {}),
      ...(wish.value ? { vehicle: wish.value.trim() } : {}),
      ...(fallbacks.value.trim() ? { fallbacks: fallbacks.value.trim().split(/[\s,]+/) } : {}),
      ...(name.value.trim() ? { job_id: name.value.trim() } : {}),
    };
    sending.value = true;
    error.value = null;
    done.value = "";
    try {
      const job = await post<Job>("/jobs", body, { "Idempotency-Key": keyOf(body) });
      done.value = t("ordered", job.id);
      written = "";
      order.carrier.value = name.value = "";
    } catch (failure) {
      error.value = failure;
    } finally {
      sending.value = false;
    }
  };
  const wrong = error.value instanceof Refused ? error.value.field : "";
  return (
    <form class="card transfer" onSubmit={(event) => void send(event)}>
      <h2>{t("new_transfer")}</h2>
      <Place label={t("source")} value={order.source.value} choose={orderFrom} wrong={wrong === "source"} vehicles />
      <Place
        label={t("destination")}
        value={order.destination.value}
        choose={orderTo}
        wrong={wrong === "destination"}
        partner={order.source.value}
      />
      <label>
        <span>{t("carrier")}</span>
        <input
          name="carrier"
          value={order.carrier.value}
          maxLength={64}
          placeholder={known || t("carrier_optional")}
          aria-invalid={wrong === "carrier"}
          autocomplete="off"
          onInput={(event) => (order.carrier.value = event.currentTarget.value)}
        />
      </label>
      <label class="narrow">
        <span>{t("priority")}</span>
        <input
          name="priority"
          type="number"
          min="0"
          max="99"
          required
          value={priority.value}
          aria-invalid={wrong === "priority"}
          onInput={(event) => (priority.value = event.currentTarget.value)}
        />
      </label>
      <Button needs="POST /jobs" type="submit" class="primary" disabled={sending.value}>
        {sending.value ? t("ordering") : t("order")}
      </Button>
      <details class="more-order">
        <summary>{t("more")}</summary>
        <div class="fields">
          <Field label={t("vehicle")} name="vehicle" value={wish} list="order-vehicles" hint={t("any")} />
          <Field label={t("job_id")} name="job_id" value={name} hint={t("given_here")} />
          <Field label={t("fallbacks_label")} name="fallbacks" value={fallbacks} hint={t("none")} wide />
        </div>
        <datalist id="order-vehicles">{layout.value?.vehicles.map(({ id }) => <option key={id} value={id} />)}</datalist>
      </details>
      <div class="outcome">
        {error.value ? <Problem error={error.value} /> : <span class="done" role="status">{done.value}</span>}
      </div>
    </form>
  );
}

interface PlaceProps {
  label: string;
  value: string;
  choose: (id: string) => void;
  wrong: boolean;
  vehicles?: boolean;
  /** The end chosen already: only ends that a vehicle can join to it are offered. */
  partner?: string;
}

function Place(props: PlaceProps) {
  const world = worldOf(layout.value, props.partner ?? "");
  const places = (layout.value?.stations ?? []).filter(({ kind }) => world === null || worldOfKind(kind) === world);
  const groups = [
    { name: t("ports"), stations: places.filter(({ kind }) => kind === "port") },
    { name: t("buffers"), stations: places.filter(({ kind }) => kind === "sbfl" || kind === "sbfr") },
    { name: t("agv_buffers"), stations: places.filter(({ kind }) => kind === "agv_buffer") },
  ];
  const loaded = props.vehicles ? vehicleList.value.filter((vehicle) => vehicle.loaded) : [];
  const shown = (id: string): string => {
    const now = stations.get(id);
    return now?.present ? `${id} · ${now.carrier ?? "■"}` : id;
  };
  return (
    <label>
      <span>{props.label}</span>
      <select
        required
        value={props.value}
        aria-invalid={props.wrong}
        onChange={(event) => props.choose(event.currentTarget.value)}
      >
        <option value="">{t("choose")}</option>
        {groups
          .filter((group) => group.stations.length > 0)
          .map((group) => (
            <optgroup key={group.name} label={group.name}>
              {group.stations.map(({ id }) => (
                <option key={id} value={id}>
                  {shown(id)}
                </option>
              ))}
            </optgroup>
          ))}
        {loaded.length > 0 && (
          <optgroup label={t("loaded_vehicles")}>
            {loaded.map(({ id, carrier }) => (
              <option key={id} value={id}>
                {carrier ? `${id} · ${carrier}` : id}
              </option>
            ))}
          </optgroup>
        )}
      </select>
    </label>
  );
}
