/** Sends a vehicle to a station before its lot is ready; it stays idle there. */
import { useSignal } from "@preact/signals";
import { post } from "../api";
import { layout } from "../store";
import { t } from "../texts";
import type { Vehicle } from "../types";
import { Field, Told, useAsking } from "./asking";
import { Sure } from "./Sure";

export function Stage({ id }: { id: string }) {
  const vehicle = useSignal("");
  const asking = useAsking();
  const send = (): void =>
    void asking.ask(async () => {
      const body = vehicle.value.trim() ? { vehicle: vehicle.value.trim() } : {};
      const sent = await post<Vehicle>(`/stations/${encodeURIComponent(id)}/stage`, body);
      vehicle.value = sent.id;
    }, t("staged"));
  return (
    <details class="part acts">
      <summary>{t("stage")}</summary>
      <div class="fields">
        <Field label={t("vehicle")} name="stage" value={vehicle} list="stage-vehicles" hint={t("nearest_free")} />
        <div class="acts-row">
          <Sure needs="POST /stations/{station}/stage" label={t("stage")} does={send} />
        </div>
      </div>
      <datalist id="stage-vehicles">{layout.value?.vehicles.map((one) => <option key={one.id} value={one.id} />)}</datalist>
      <Told asking={asking} />
    </details>
  );
}
