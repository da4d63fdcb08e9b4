/** Doors, buffers and chargers, each in one line. */
import { colourOfDevice, DEVICE_LOOKS } from "../shows";
import { chooseDevice, deviceNow, layout, lookAt, type MachineKind, machines, passers, presence, selected } from "../store";
import { t } from "../texts";

export function DeviceList() {
  return (
    <ul class="scroll machines">
      {machines.value.map(({ id, kind }) => (
        <Row key={id} id={id} kind={kind} />
      ))}
    </ul>
  );
}

function Row({ id, kind }: { id: string; kind: MachineKind }) {
  const device = deviceNow(id);
  void presence.value;
  const look = lookAt(id);
  const station = layout.value?.stations.find((one) => one.buffer === id)?.id;
  const barcode = layout.value?.chargers.find((one) => one.id === id)?.barcode;
  const who = kind === "buffer" ? (device?.lock?.owner ?? "") : passers(id).join(", ");
  const why = device?.alarm || device?.contradiction || device?.out_of_service || device?.reason || "";
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
