/** All vehicles in a table: what each does, and why one waits. */
import { useSignal } from "@preact/signals";
import { counted } from "../known";
import { LOOKS, lookOf } from "../shows";
import { selected, vehicleList } from "../store";
import { said, t, tell } from "../texts";
import type { Vehicle } from "../types";
import { Name } from "./Name";
import { Table } from "./Table";

const GROUPS = ["all", "alarm", "held", "waiting", "moving", "handling", "charging", "idle", "gone"] as const;

/** Idle at a parking place is said so: else one would look for why it does not move. */
export function doing(vehicle: Vehicle): string {
  return vehicle.parked && vehicle.activity === "idle" ? t("idle_parked") : said(vehicle.activity);
}

export function Vehicles() {
  const letters = useSignal("");
  const group = useSignal<(typeof GROUPS)[number]>("all");
  const wanted = letters.value.trim().toLowerCase();
  const rows = vehicleList.value.filter(
    (vehicle) =>
      (group.value === "all" || lookOf(vehicle) === group.value) &&
      [vehicle.id, vehicle.job, vehicle.carrier, vehicle.goal, vehicle.barcode].some((name) => name?.toLowerCase().includes(wanted) ?? !wanted),
  );
  return (
    <section class="room" aria-label={t("vehicles")}>
      <div class="head">
        <h2>
          {t("vehicles")} {counted(rows.length)}
        </h2>
        <select aria-label={t("activity")} value={group.value} onChange={(event) => (group.value = event.currentTarget.value as "all")}>
          {GROUPS.map((name) => (
            <option key={name} value={name}>
              {name === "all" ? t("all") : t(`look_${name}`)}
            </option>
          ))}
        </select>
        <input
          type="search"
          aria-label={t("filter")}
          placeholder={t("filter")}
          value={letters.value}
          onInput={(event) => (letters.value = event.currentTarget.value)}
        />
      </div>
      <Table
        label={t("vehicles")}
        rows={rows}
        keyOf={(vehicle) => vehicle.id}
        pick={({ id }) => (selected.value = { kind: "vehicle", id })}
        chosen={selected.value?.kind === "vehicle" ? selected.value.id : null}
        none={t("nothing_found")}
        columns={[
          {
            name: t("vehicle"),
            by: ({ id }) => id,
            of: (vehicle) => (
              <button type="button" class="text" onClick={() => (selected.value = { kind: "vehicle", id: vehicle.id })}>
                <i class="dot" style={{ background: LOOKS[lookOf(vehicle)] }} /> {vehicle.id}
              </button>
            ),
          },
          { name: t("activity"), by: doing, of: (vehicle) => <span style={{ color: LOOKS[lookOf(vehicle)] }}>{doing(vehicle)}</span> },
          { name: t("place"), by: ({ barcode }) => barcode, of: ({ barcode }) => barcode ?? t("unknown") },
          {
            name: t("carrier"),
            by: ({ carrier, loaded }) => carrier ?? (loaded ? "~" : null),
            of: ({ carrier, loaded }) => (loaded ? (carrier ?? t("loaded")) : ""),
          },
          { name: t("job"), by: ({ job }) => job, of: ({ job }) => <Name id={job} /> },
          { name: t("goal"), by: ({ goal }) => goal, of: ({ goal }) => <Name id={goal} /> },
          { name: t("why"), wraps: true, of: (vehicle) => tell(vehicle.hold?.reason ?? vehicle.waiting) },
        ]}
      />
    </section>
  );
}
