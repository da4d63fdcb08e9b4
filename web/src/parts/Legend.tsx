/** What the colours and forms on the map mean; what the plant does not have is left out. */
import { heatShown, layers } from "../layers";
import { closedWays } from "../closed";
import { plan } from "../plan";
import { LOOKS, type Look, SIGNS } from "../shows";
import { layout } from "../store";
import { t, type Word } from "../texts";

export function Legend() {
  const plant = layout.value;
  const agvs = plant?.vehicles.some((vehicle) => vehicle.kind === "agv") ?? false;
  const looks = (Object.keys(LOOKS) as Look[]).filter((look) => look !== "charging" || agvs);
  const zones = layers.value.zones ? (plant?.zones ?? []) : [];
  return (
    <div class="legend">
      {looks.map((look) => (
        <span key={look}>
          <i class="dot" style={{ background: LOOKS[look] }} />
          {t(`look_${look}` as Word)} {SIGNS[look]}
        </span>
      ))}
      <span>
        <i class="mark-unknown">?</i>
        {t("legend_unknown")}
      </span>
      <span>
        <i class="box" />
        {t("legend_carrier")}
      </span>
      {layers.value.grants && (
        <span>
          <i class="path granted" />
          {t("legend_granted")}
        </span>
      )}
      {plan.value.length > 0 && (
        <span>
          <i class="path planned" />
          {t("legend_planned")}
        </span>
      )}
      {layers.value.closures && closedWays.value.length > 0 && (
        <span>
          <i class="path closed">×</i>
          {t("closed")}
        </span>
      )}
      {zones.some((zone) => zone.no_stop && !zone.soft) && (
        <span>
          <i class="zone" />
          {t("legend_zone")}
        </span>
      )}
      {zones.some((zone) => zone.soft) && (
        <span>
          <i class="zone soft" />
          {t("legend_soft")}
        </span>
      )}
      {plant && plant.doors.length > 0 && (
        <span>
          <i class="door shut" />
          <i class="door ajar" />
          {t("legend_door")}
        </span>
      )}
      {plant && plant.chargers.length > 0 && (
        <span>
          <i class="flash">↯</i>
          {t("charger")}
        </span>
      )}
      {heatShown.value && (
        <span class="heat-key">
          {t(heatShown.value === "waiting" ? "heat_waiting" : "heat_traffic")}: {t("little")}
          {[1, 2, 3, 4, 5, 6].map((step) => (
            <i key={step} style={{ background: `var(--heat-${step})` }} />
          ))}
          {t("much")}
        </span>
      )}
    </div>
  );
}
