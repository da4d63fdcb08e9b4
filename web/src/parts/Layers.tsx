/** Which layers the map shows. */
import { useSignal } from "@preact/signals";
import type { HeatKind } from "../heat";
import { HEAT_HOURS, heatHours, heatShown, LAYERS, layers, show } from "../layers";
import { t } from "../texts";
import { useClosed } from "./menu";

const HEATS: (HeatKind | null)[] = [null, "waiting", "traffic"];

export function Layers() {
  const open = useSignal(false);
  const box = useClosed(open);
  return (
    <div {...box} class="layers">
      <button type="button" aria-expanded={open.value} onClick={() => (open.value = !open.value)}>
        {t("layers")}
      </button>
      {open.value && (
        <div role="group" aria-label={t("layers")}>
          {LAYERS.map((layer) => (
            <label key={layer}>
              <input type="checkbox" checked={layers.value[layer]} onChange={(event) => show(layer, event.currentTarget.checked)} />
              {t(`layer_${layer}`)}
            </label>
          ))}
          <b>{t("heat")}</b>
          {HEATS.map((kind) => (
            <label key={kind ?? "off"}>
              <input type="radio" name="heat" checked={heatShown.value === kind} onChange={() => (heatShown.value = kind)} />
              {t(kind === null ? "heat_off" : kind === "waiting" ? "heat_waiting" : "heat_traffic")}
            </label>
          ))}
          {heatShown.value && (
            <label>
              {t("heat_over")}
              <select value={heatHours.value} onChange={(event) => (heatHours.value = Number(event.currentTarget.value))}>
                {HEAT_HOURS.map((hours) => (
                  <option key={hours} value={hours}>
                    {hours ? t("heat_hours", hours) : t("heat_seen")}
                  </option>
                ))}
              </select>
            </label>
          )}
        </div>
      )}
    </div>
  );
}
