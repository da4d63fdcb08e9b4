/** What people decide about a door, buffer or charger: kept open or closed, locked out, out of service. */
import { againstPin } from "../against";
import { call, post } from "../api";
import { t } from "../texts";
import type { Device } from "../types";
import { type Decision, Reasoned } from "./Reasoned";

export function DeviceDecisions({ device }: { device: Device }) {
  const path = `/devices/${encodeURIComponent(device.id)}`;
  const pins: Decision[] =
    device.kind !== "door"
      ? []
      : device.pin
        ? [{ label: t("unpin"), needs: "DELETE /devices/{device}/pin", bare: true, does: () => call("DELETE", `${path}/pin`) }]
        : (["open", "closed"] as const).map((position) => ({
            label: t(`pin_${position}`),
            needs: "PUT /devices/{device}/pin" as const,
            against: againstPin(device, position),
            does: (reason: string) => call("PUT", `${path}/pin`, { position, reason }),
          }));
  const decisions: Decision[] = [
    ...pins,
    device.lockout
      ? { label: t("lift_lockout"), needs: "DELETE /devices/{device}/lockout", bare: true, grave: true, does: () => call("DELETE", `${path}/lockout`) }
      : { label: t("lock_out"), needs: "POST /devices/{device}/lockout", grave: true, does: (reason) => post(`${path}/lockout`, { reason }) },
    device.out_of_service
      ? { label: t("put_back"), needs: "PUT /devices/{device}/service", bare: true, does: () => call("PUT", `${path}/service`, { in_service: true }) }
      : { label: t("take_out"), needs: "PUT /devices/{device}/service", grave: true, does: (reason) => call("PUT", `${path}/service`, { in_service: false, reason }) },
  ];
  return (
    <details class="part acts">
      <summary>{t("decide")}</summary>
      <Reasoned decisions={decisions} />
    </details>
  );
}
