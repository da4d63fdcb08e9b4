/** Doors, buffers and chargers, each in one line. */
import { colourOfDevice, DEVICE_LOOKS } from "../shows";
import { chooseDevice, deviceNow, layout, lookAt, type MachineKind, machines, passers, presence, selected } from "../store";
import { t, tell } from "../texts";
import type { Device } from "../types";

export function DeviceList() {
  return (
    <ul class="scroll machines">
      {machines.value.map(({ id, kind }) => (
        <Row key={id} id={id} kind={kind} />
      ))}
    </ul>
  );
}

/** What people have decided about a device: it does not do what its state alone would let one expect. */
function barred({ lockout, out_of_service, pin }: Device): string {
  if (lockout) return `${t("locked", lockout.owner)} ${lockout.reason}`;
  if (out_of_service) return `${t("out_of_service")}: ${out_of_service}`;
  return pin ? `${t("pinned", t(pin.position === "open" ? "device_open" : "device_closed"), pin.owner)}: ${pin.reason}` : "";
}

function Row({ id, kind }: { id: string; kind: MachineKind }) {
  const device = deviceNow(id);
  void presence.value;
  const look = lookAt(id);
  const station = layout.value?.stations.find((one) => one.buffer === id)?.id;
  const barcode = layout.value?.chargers.find((one) => one.id === id)?.barcode;
  const who = kind === "buffer" ? (device?.lock?.owner ?? "") : passers(id).join(", ");
  const why = tell(device?.alarm || device?.contradiction || (device && barred(device)) || device?.reason || "");
  const chosen = selected.value?.id === id || (station !== undefined && selected.value?.id === station);
  return (
    <li>
      <button type="button" class="row" aria-pressed={chosen} data-device={id} onClick={() => chooseDevice(id)}>
        <i class="dot" style={{ background: colourOfDevice(device, look) }} />
        <b>{id}</b>
        <span>{t(kind)}</span>
        <span style={{ color: DEVICE_LOOKS[look] }}>{t(`device_${look}`)}</span>
        <span>{station ?? barcode ?? ""}</span>
        <span>{who}</span>
        <span class={device?.alarm ? "more bad" : "more"} title={why}>
          {why}
        </span>
      </button>
    </li>
  );
}
