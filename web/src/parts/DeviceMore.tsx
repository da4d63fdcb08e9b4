/** What was asked of a door or buffer lately and what became of it, and the packets on its line. */
import { useSignal } from "@preact/signals";
import { clock } from "../shows";
import { changes } from "../store";
import { said, t, tell } from "../texts";
import type { Command, Device } from "../types";
import { useRead } from "./asking";
import { LineFrames } from "./Frames";
import { commandName } from "./VehicleCommands";

export function DeviceMore({ device }: { device: Device }) {
  const path = `/devices/${encodeURIComponent(device.id)}`;
  return (
    <>
      <Past path={path} />
      {device.link && <LineFrames path={`${path}/frames`} />}
    </>
  );
}

function Past({ path }: { path: string }) {
  const open = useSignal(false);
  const { value } = useRead<{ items: Command[] }>(open.value ? `${path}/commands?limit=12` : null, changes.devices.value);
  return (
    <details class="part acts" open={open.value} onToggle={(event) => (open.value = event.currentTarget.open)}>
      <summary>{t("last_commands")}</summary>
      {value?.items.length === 0 && <p class="nothing">{t("no_commands")}</p>}
      <table class="bits">
        <tbody>
          {value?.items.map((command) => (
            <tr key={command.cmd_id}>
              <th>{clock(command.opened)}</th>
              <td>{said(`cs_${command.state}`)}</td>
              <td>
                {commandName(command.kind)} · {command.actor} {tell(command.outcome)}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </details>
  );
}
