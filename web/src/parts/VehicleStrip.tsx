/** All vehicles at a glance, reachable by key; a list to choose from where there are too many. */
import { LOOKS, lookOf } from "../shows";
import { selected, vehicleList } from "../store";
import { said, t } from "../texts";

const CHIPS = 40;

export function VehicleStrip() {
  const list = vehicleList.value;
  const pick = selected.value?.kind === "vehicle" ? selected.value.id : "";
  if (list.length > CHIPS) {
    return (
      <nav class="strip" aria-label={t("vehicles")}>
        <select value={pick} onChange={(event) => choose(event.currentTarget.value)}>
          <option value="">{t("choose_vehicle")}</option>
          {list.map((vehicle) => (
            <option key={vehicle.id} value={vehicle.id}>
              {vehicle.id} · {said(vehicle.activity)}
            </option>
          ))}
        </select>
      </nav>
    );
  }
  return (
    <nav class="strip" aria-label={t("vehicles")}>
      {list.map((vehicle) => {
        const look = lookOf(vehicle);
        return (
          <button
            type="button"
            key={vehicle.id}
            class="chip"
            aria-pressed={pick === vehicle.id}
            style={{ "--look": LOOKS[look] }}
            title={vehicle.waiting || vehicle.hold?.reason || ""}
            onClick={() => choose(pick === vehicle.id ? "" : vehicle.id)}
          >
            <b>
              {vehicle.id}
              {vehicle.loaded && <i class="box" />}
            </b>
            <small>{look === "gone" ? t("look_gone") : said(vehicle.activity)}</small>
          </button>
        );
      })}
    </nav>
  );
}

function choose(id: string): void {
  selected.value = id ? { kind: "vehicle", id } : null;
}
