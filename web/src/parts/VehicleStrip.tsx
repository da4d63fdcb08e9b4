/** All vehicles at a glance, reachable by key; how many do what where there are too many. */
import { none } from "../known";
import { room } from "../route";
import { LOOKS, type Look, lookOf } from "../shows";
import { selected, vehicleList } from "../store";
import { t, tell } from "../texts";
import { doing } from "./Vehicles";

const CHIPS = 40;

export function VehicleStrip() {
  const list = vehicleList.value;
  const pick = selected.value?.kind === "vehicle" ? selected.value.id : "";
  if (list.length > CHIPS) return <Groups />;
  const unknown = none("");
  if (list.length === 0 && unknown) return <p class="strip nothing">{unknown}</p>;
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
            title={tell(vehicle.waiting || vehicle.hold?.reason || "")}
            onClick={() => choose(pick === vehicle.id ? "" : vehicle.id)}
          >
            <b>
              {vehicle.id}
              {vehicle.loaded && <i class="box" />}
            </b>
            <small>{look === "gone" ? t("look_gone") : doing(vehicle)}</small>
          </button>
        );
      })}
    </nav>
  );
}

/** A fleet too large for a chip each: how many look how; the rest is in the room of vehicles. */
function Groups() {
  const counts = new Map<Look, number>();
  for (const vehicle of vehicleList.value) counts.set(lookOf(vehicle), (counts.get(lookOf(vehicle)) ?? 0) + 1);
  return (
    <nav class="strip" aria-label={t("vehicles")}>
      {(Object.keys(LOOKS) as Look[]).map(
        (look) =>
          counts.has(look) && (
            <button type="button" key={look} class="chip" style={{ "--look": LOOKS[look] }} onClick={() => (room.value = "vehicles")}>
              <b>{counts.get(look)}</b>
              <small>{t(`look_${look}`)}</small>
            </button>
          ),
      )}
    </nav>
  );
}

function choose(id: string): void {
  selected.value = id ? { kind: "vehicle", id } : null;
}
