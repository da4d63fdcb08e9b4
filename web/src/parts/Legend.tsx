/** What the colours and forms on the map mean; what the plant does not have is left out. */
import { LOOKS, type Look } from "../shows";
import { layout } from "../store";
import { t, type Word } from "../texts";

export function Legend() {
  const plant = layout.value;
  const agvs = plant?.vehicles.some((vehicle) => vehicle.kind === "agv") ?? false;
  const looks = (Object.keys(LOOKS) as Look[]).filter((look) => look !== "charging" || agvs);
  return (
    <div class="legend">
      {looks.map((look) => (
        <span key={look}>
          <i class="dot" style={{ background: LOOKS[look] }} />
          {t(`look_${look}` as Word)}
        </span>
      ))}
      <span>
        <i class="box" />
        {t("legend_carrier")}
      </span>
      <span>
        <i class="zone" />
        {t("legend_zone")}
      </span>
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
    </div>
  );
}
