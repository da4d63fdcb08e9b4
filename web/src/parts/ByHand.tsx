/** A new version of a port's DEST or a vehicle's OFFSET, written by hand: only if nobody else wrote one meanwhile. */
import { useSignal } from "@preact/signals";
import { call } from "../api";
import { t } from "../texts";
import type { PulsesVersion } from "../types";
import { Field, Told, useAsking } from "./asking";
import { Sure } from "./Sure";

const AXES = ["shft", "rota", "lift"] as const;

export function ByHand({ kind, path, newest, after }: { kind: "station" | "vehicle"; path: string; newest: PulsesVersion | undefined; after: () => void }) {
  const values = { shft: useSignal(String(newest?.shft ?? "")), rota: useSignal(String(newest?.rota ?? "")), lift: useSignal(String(newest?.lift ?? "")) };
  const asking = useAsking();
  const whole = AXES.every((axis) => /^-?\d+$/.test(values[axis].value.trim()));
  const write = async (): Promise<void> => {
    const body = Object.fromEntries(AXES.map((axis) => [axis, Number(values[axis].value)]));
    const match: Record<string, string> = newest ? { "If-Match": `"${newest.version}"` } : {};
    if (await asking.ask(() => call("PUT", path, body, match))) after();
  };
  return (
    <details>
      <summary>{t("write_by_hand")}</summary>
      <div class="stack">
        <div class="fields three">
          {AXES.map((axis) => (
            <Field key={axis} label={axis.toUpperCase()} name={axis} type="number" value={values[axis]} />
          ))}
        </div>
        <div class="acts-row">
          <Sure
            needs={kind === "station" ? "PUT /stations/{station}/dest" : "PUT /vehicles/{vehicle}/offset"}
            label={t("write")}
            disabled={!whole}
            does={() => void write()}
          />
        </div>
        <Told asking={asking} />
      </div>
    </details>
  );
}
