/** What was recorded of the chosen thing at the moment that is shown: to be read, nothing can be done about it any more. */
import { clock, colourOfDevice, LOOKS, lookOf, lookOfDrive, TONES } from "../shows";
import { deviceNow, driveNow, ENDED, jobList, layout, lookAt, type Selection, stationNow, vehicleNow } from "../store";
import { said, t, tell } from "../texts";
import { COLOURS, Notes as DriveNotes } from "./DrivePanel";
import { Name } from "./Name";
import { Fact, Panel } from "./Panel";
import { Notes } from "./VehiclePanel";
import { doing } from "./Vehicles";

export function PastPanel({ pick }: { pick: NonNullable<Selection> }) {
  switch (pick.kind) {
    case "vehicle":
      return <PastVehicle id={pick.id} />;
    case "station":
      return <PastStation id={pick.id} />;
    case "job":
      return <PastJob id={pick.id} />;
    case "device":
      return <PastDevice id={pick.id} />;
    case "drive":
      return <PastDrive id={pick.id} />;
  }
}

function Unknown({ id }: { id: string }) {
  return (
    <Panel title={id} tag={t("unknown")} colour="var(--dim)">
      <p class="nothing">{t("not_then")}</p>
    </Panel>
  );
}

const upper = (word: string | null): string => word?.toUpperCase() ?? "–";

function PastVehicle({ id }: { id: string }) {
  const then = vehicleNow(id);
  if (!then) return <Unknown id={id} />;
  const load = then.loaded === null ? t("unknown") : then.loaded ? (then.carrier ?? t("loaded")) : t("empty");
  return (
    <Panel title={id} tag={doing(then)} colour={LOOKS[lookOf(then)]}>
      <Notes vehicle={then} />
      <dl>
        <Fact name={t("state")}>
          {said(then.state)} · {said(then.service)}
        </Fact>
        <Fact name={t("mode")}>
          {upper(then.mode)} · {upper(then.oper)}
          {then.code ? ` · 0x${then.code.toString(16).toUpperCase().padStart(4, "0")}` : ""}
        </Fact>
        <Fact name={t("carrier")}>{load}</Fact>
        <Fact name={t("place")}>{then.barcode ?? t("unknown")}</Fact>
        <Fact name={t("job")}>{then.job ? <Name id={then.job} /> : t("none")}</Fact>
        <Fact name={t("goal")}>{then.goal ? <Name id={then.goal} /> : t("none")}</Fact>
        <Fact name={t("granted")}>{then.granted.length > 0 ? then.granted.join(" ") : t("none")}</Fact>
      </dl>
    </Panel>
  );
}

function PastStation({ id }: { id: string }) {
  const then = stationNow(id);
  if (!then) return <Unknown id={id} />;
  const occupied = then.present === null ? t("unknown") : then.present ? t("yes") : t("no");
  const buffer = layout.value?.stations.find((station) => station.id === id)?.buffer;
  return (
    <Panel title={id} tag={said(then.kind)} colour={then.present ? "var(--ink-carrier)" : "var(--ink-mark)"}>
      <dl>
        <Fact name={t("present")}>
          {occupied} <small>({then.verified ? t("verified") : t("believed")})</small>
        </Fact>
        <Fact name={t("carrier")}>{then.carrier ?? t("none")}</Fact>
        <Fact name={t("reserved")}>{then.reserved || t("no")}</Fact>
        <Fact name={t("out_of_service")}>{then.out_of_service || t("no")}</Fact>
        <Fact name={t("barcode")}>{then.barcode}</Fact>
        {buffer && <Fact name={t("buffer")}>{t(`device_${lookAt(buffer)}`)}</Fact>}
      </dl>
    </Panel>
  );
}

function PastJob({ id }: { id: string }) {
  const then = jobList.value.find((job) => job.id === id);
  if (!then) return <Unknown id={id} />;
  return (
    <Panel title={id} tag={said(then.state)} colour={COLOURS[TONES[then.state] ?? "calm"]}>
      {then.reason && !ENDED.has(then.state) && (
        <p class="note waits">
          <b>{t("waits")}</b> {tell(then.reason)}
        </p>
      )}
      <dl>
        <Fact name={t("source")}>
          <Name id={then.source} />
        </Fact>
        <Fact name={t("destination")}>
          <Name id={then.destination} />
        </Fact>
        <Fact name={t("carrier")}>{then.carrier ?? t("unknown")}</Fact>
        <Fact name={t("vehicle")}>{then.vehicle ? <Name id={then.vehicle} /> : t("none")}</Fact>
        <Fact name={t("priority")}>{then.priority}</Fact>
        <Fact name={t("ordered_by")}>
          {then.actor} <small>· {clock(then.created)}</small>
        </Fact>
      </dl>
    </Panel>
  );
}

function PastDevice({ id }: { id: string }) {
  const then = deviceNow(id);
  const look = lookAt(id);
  const charger = layout.value?.chargers.some((one) => one.id === id);
  return (
    <Panel title={id} tag={t(`device_${look}`)} colour={colourOfDevice(then, look)}>
      {(then?.alarm || then?.reason) && <p class="note waits">{tell(then.alarm || then.reason)}</p>}
      <dl>
        <Fact name={t("kind")}>{t(charger ? "charger" : "door")}</Fact>
        <Fact name={t("vehicles")}>{then?.vehicles.join(", ") || t("none")}</Fact>
        {then?.out_of_service && <Fact name={t("out_of_service")}>{then.out_of_service}</Fact>}
      </dl>
    </Panel>
  );
}

/** Where it was is not recorded: only what it did, and what was wrong with it. */
function PastDrive({ id }: { id: string }) {
  const then = driveNow(id);
  if (!then) return <Unknown id={id} />;
  const { word, tone } = lookOfDrive(then);
  return (
    <Panel title={id} tag={tell(then.name)} colour={COLOURS[tone]}>
      <DriveNotes drive={then} />
      <dl>
        <Fact name={t("state")}>
          <b class={tone}>{t(`drive_${word}`)}</b>
        </Fact>
        <Fact name={t(then.mode === "error" ? "error_fact" : "operation_fact")}>
          {said(tell(then.meaning)) || "–"} <small>{then.code}</small>
        </Fact>
        <Fact name={t("moves")}>{then.moving === null ? t("unknown") : t(then.moving ? "yes" : "no")}</Fact>
        <Fact name={t("on_line")}>{t("line_number", then.line, then.address)}</Fact>
      </dl>
    </Panel>
  );
}
