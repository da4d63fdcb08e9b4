/** A person writes down what is at a station, or that it is not to be used. */
import { useSignal } from "@preact/signals";
import { call } from "../api";
import { t } from "../texts";
import type { Station } from "../types";
import { Choice, Field, Told, useAsking } from "./asking";
import { Button } from "./Button";

type Presence = "yes" | "no" | "unknown";
const KNOWN: Record<Presence, boolean | null> = { yes: true, no: false, unknown: null };

export function StationWrite({ station }: { station: Station }) {
  const present = useSignal<Presence>(station.present === null ? "unknown" : station.present ? "yes" : "no");
  const carrier = useSignal(station.carrier ?? "");
  const reserved = useSignal(station.reserved);
  const closed = useSignal(station.out_of_service);
  const asking = useAsking();
  const send = (event: Event): void => {
    event.preventDefault();
    const body = {
      present: KNOWN[present.value],
      carrier: present.value === "yes" ? carrier.value.trim() : "",
      reserved: reserved.value.trim(),
      out_of_service: closed.value.trim(),
      by_person: true,
    };
    void asking.ask(() => call("PATCH", `/stations/${encodeURIComponent(station.id)}`, body));
  };
  return (
    <details class="part acts">
      <summary>{t("write_down")}</summary>
      <form class="stack" onSubmit={send}>
        <div class="fields">
          <Choice
            label={t("present")}
            value={present}
            of={[
              ["yes", t("yes")],
              ["no", t("no")],
              ["unknown", t("unknown")],
            ]}
          />
          <Field label={t("carrier")} name="carrier" value={carrier} hint={t("unknown")} />
          <Field label={t("reserved")} name="reserved" value={reserved} hint={t("no")} />
          <Field label={t("out_of_service")} name="out_of_service" value={closed} hint={t("no")} />
        </div>
        <div class="acts-row">
          <Button needs="PATCH /stations/{station}" type="submit">
            {t("write_down")}
          </Button>
        </div>
        <Told asking={asking} />
      </form>
    </details>
  );
}
