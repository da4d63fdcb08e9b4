/** One door, buffer or charger: its state and since when, who has it, what is wrong, and the two commands it takes. */
import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { againstDevice } from "../against";
import { post, serverNow } from "../api";
import { stopped } from "../around";
import { clock, colourOfDevice, DEVICE_LOOKS, type DeviceLook, span } from "../shows";
import { deviceNow, layout, lookAt, machines, passers, presence, selected, tick } from "../store";
import { t, tell } from "../texts";
import type { Device } from "../types";
import { DeviceDecisions } from "./DeviceDecisions";
import { DeviceMore } from "./DeviceMore";
import { Fact, Panel } from "./Panel";
import { Problem } from "./Problem";
import { Sure } from "./Sure";

const COMMANDS = { door: ["open", "close"], buffer: ["lock", "unlock"], charger: [] } as const;

export function DevicePanel({ id }: { id: string }) {
  const kind = machines.value.find((machine) => machine.id === id)?.kind;
  const now = deviceNow(id);
  void presence.value;
  if (!kind) return null;
  return (
    <Panel title={id} tag={t(kind)} colour={colourOfDevice(now, lookAt(id))}>
      <DeviceBody id={id} />
    </Panel>
  );
}

/** What there is to say of a device, in its own panel or in that of its station. */
export function DeviceBody({ id }: { id: string }) {
  const kind = machines.value.find((machine) => machine.id === id)?.kind;
  const now = deviceNow(id);
  void tick.value;
  void presence.value;
  if (!kind) return null;
  const barcode = layout.value?.chargers.find((charger) => charger.id === id)?.barcode;
  return (
    <>
      {now && <Notes device={now} />}
      <dl>
        <Fact name={t("state")}>
          <State look={lookAt(id)} device={now} />
        </Fact>
        {kind !== "buffer" && (
          <Fact name={t(kind === "charger" ? "charges" : "passing")}>
            <Vehicles ids={passers(id)} />
          </Fact>
        )}
        {now?.waiting && now.waiting.length > 0 && (
          <Fact name={t("wait_for_it")}>
            <Vehicles ids={now.waiting} />
          </Fact>
        )}
        {kind === "buffer" && now?.lock !== undefined && <Fact name={t("lock_for")}>{lockOf(now)}</Fact>}
        {now?.pending && <Fact name={t("pending")}>{now.pending}</Fact>}
        {barcode && <Fact name={t("barcode")}>{barcode}</Fact>}
        {now?.link && <Fact name={t("on_line")}>{t("line_number", now.link, now.number ?? "")}</Fact>}
        {kind !== "charger" && !now?.fresh && (
          <Fact name={t("seen")}>{now?.seen ? t("ago", span(serverNow() - Date.parse(now.seen))) : "–"}</Fact>
        )}
      </dl>
      <Commands id={id} commands={COMMANDS[kind]} />
      {now && <DeviceDecisions device={now} />}
      {now && kind !== "charger" && <DeviceMore device={now} />}
    </>
  );
}

function State({ look, device }: { look: DeviceLook; device: Device | undefined }) {
  const last = device && !device.fresh && device.state ? t("last_word", t(`device_${stateOf(device.state)}`)) : "";
  return (
    <>
      <b style={{ color: DEVICE_LOOKS[look] }}>{t(`device_${look}`)}</b>
      {device?.since && device.fresh && <small> · {t("since", clock(device.since))}</small>}
      {last && <small> · {last}</small>}
    </>
  );
}

type State = "open" | "closed" | "cart" | "no_cart" | "busy" | "unknown" | "error";
const STATES = new Set<string>(["open", "closed", "cart", "no_cart", "busy", "error"]);
const stateOf = (word: string): State => (STATES.has(word) ? (word as State) : "unknown");

function lockOf(device: Device): ComponentChildren {
  const { lock } = device;
  if (!lock) return t("not_locked");
  return (
    <>
      {lock.owner} <small>· {lock.locked === null ? t("lock_unsure") : t("since", clock(lock.since))}</small>
    </>
  );
}

function Vehicles({ ids }: { ids: string[] }) {
  if (ids.length === 0) return <>{t("nobody")}</>;
  return (
    <span class="names">
      {ids.map((id) => (
        <button type="button" key={id} class="text" onClick={() => (selected.value = { kind: "vehicle", id })}>
          {id}
        </button>
      ))}
    </span>
  );
}

function Notes({ device }: { device: Device }) {
  const { lockout, pin } = device;
  return (
    <>
      {device.alarm && (
        <p class="note alarm">
          <b>{tell(device.alarm)}</b> {device.remedy && <em>{tell(device.remedy)}</em>}
        </p>
      )}
      {!device.fresh && device.reason && !device.alarm && device.kind !== "charger" && (
        <p class="note held">
          <b>{t("device_silent")}</b> {tell(device.reason)}
        </p>
      )}
      {device.contradiction && (
        <p class="note held">
          <b>{t("contradicts")}</b> {tell(device.contradiction)}
        </p>
      )}
      {lockout && (
        <p class="note held">
          <b>{t("locked", lockout.owner)}</b> {lockout.reason}
        </p>
      )}
      {device.out_of_service && (
        <p class="note held">
          <b>{t("out_of_service")}</b> {device.out_of_service}
        </p>
      )}
      {pin && (
        <p class="note waits">
          <b>{t("pinned", t(pin.position === "open" ? "device_open" : "device_closed"), pin.owner)}</b> {pin.reason}
        </p>
      )}
    </>
  );
}

function Commands({ id, commands }: { id: string; commands: readonly ("open" | "close" | "lock" | "unlock")[] }) {
  const error = useSignal<unknown>(null);
  const done = useSignal("");
  const now = deviceNow(id);
  if (commands.length === 0) return null;
  const send = (command: "open" | "close" | "lock" | "unlock"): void => {
    error.value = null;
    done.value = "";
    post(`/devices/${encodeURIComponent(id)}/commands`, { command }).then(
      () => (done.value = t("asked", t(`cmd_${command}`))),
      (failure: unknown) => (error.value = failure),
    );
  };
  return (
    <>
      <div class="buttons" data-commands={id}>
        {commands.map((command) => (
          <Sure key={command} needs="POST /devices/{device}/commands" label={t(`cmd_${command}`)} does={() => send(command)} {...stopped(againstDevice(now, command))} />
        ))}
      </div>
      <Problem error={error.value} />
      {done.value && (
        <span class="done" role="status">
          {done.value}
        </span>
      )}
    </>
  );
}
