/** Below the map: what has happened, and the plant's other machines, each a list to look through and to choose from. */
import { useSignal } from "@preact/signals";
import { lookOfDrive, signOfDevice } from "../shows";
import { changes, devices, driveList, layout, lookAt, machines } from "../store";
import { t } from "../texts";
import { DeviceList } from "./DeviceList";
import { DriveList } from "./DriveList";
import { Events } from "./Events";
import { LineList } from "./LineList";

type Tab = "events" | "devices" | "drives" | "lines";

export function Below() {
  const tab = useSignal<Tab>("events");
  void changes.devices.value;
  const counts = { events: 0, devices: machines.value.length, drives: driveList.value.length, lines: layout.value?.links?.length ?? 0 };
  const troubles = {
    events: 0,
    devices: machines.value.filter(({ id }) => /[!?]/.test(signOfDevice(devices.get(id), lookAt(id)))).length,
    drives: driveList.value.filter((drive) => lookOfDrive(drive).tone === "bad").length,
    lines: 0,
  };
  const tabs = (Object.keys(counts) as Tab[]).filter((one) => one === "events" || counts[one] > 0);
  const shown = tabs.includes(tab.value) ? tab.value : "events";
  return (
    <section class="card below" aria-label={t(shown)}>
      <h2>
        {tabs.length === 1 && t("events")}
        {tabs.length > 1 && (
          <span class="tabs">
            {tabs.map((one) => (
              <button type="button" key={one} aria-pressed={shown === one} onClick={() => (tab.value = one)}>
                {t(one)} {counts[one] || ""}
                {troubles[one] > 0 && <b class="badge">! {troubles[one]}</b>}
              </button>
            ))}
          </span>
        )}
      </h2>
      {shown === "events" && <Events />}
      {shown === "devices" && <DeviceList />}
      {shown === "drives" && <DriveList />}
      {shown === "lines" && <LineList />}
    </section>
  );
}
