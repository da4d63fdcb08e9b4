/** All that can be asked of a vehicle: each command pressed twice, since it moves or stops something. */
import { useSignal } from "@preact/signals";
import { type Against, againstAgv, againstCommand, againstHandling, againstMove, againstRecovery } from "../against";
import { call, post } from "../api";
import { around, stopped } from "../around";
import { clock } from "../shows";
import { changes, layout, vehicleNow } from "../store";
import { said, t, tell, type Word } from "../texts";
import type { Command, Vehicle } from "../types";
import { Choice, Field, Told, useAsking, useRead } from "./asking";
import { AgvCommands } from "./AgvCommands";
import { Reasoned } from "./Reasoned";
import { Sure } from "./Sure";

const PLAIN = [
  "status",
  "stop_by_host",
  "stop",
  "auto",
  "alarm_clear",
  "servo_on",
  "servo_off",
  "search_home",
  "go_home",
  "system_reset",
] as const;
const AGV_PLAIN = ["stop", "alarm_clear", "agv_mark_stop"] as const;
/** An AGV has no MANT that a stop would lead to. */
const AGV_WORDS: Record<string, Word> = { stop: "vc_agv_stop" };
const LIFTS = ["up", "down", "stop"] as const;

export function VehicleCommands({ vehicle }: { vehicle: Vehicle }) {
  const asking = useAsking();
  // By the plant file: one that was not heard yet has told nothing of itself.
  const agv = layout.value?.vehicles.find(({ id }) => id === vehicle.id)?.kind === "agv";
  const path = `/vehicles/${encodeURIComponent(vehicle.id)}`;
  const send = (body: object): void => void asking.ask(() => post(`${path}/commands`, body), t("sent"));
  const plain: readonly string[] = agv ? AGV_PLAIN : PLAIN;
  const now = around();
  const against = (command: string): Against => (agv ? againstAgv : againstCommand)(vehicle, command, now);
  const charge = vehicle.agv?.charging ? "off" : "on";
  return (
    <details class="part acts">
      <summary>{t("commands")}</summary>
      <div class="stack">
        <div class="acts-row" data-commands={vehicle.id}>
          {plain.map((command) => (
            <Sure
              needs="POST /vehicles/{vehicle}/commands"
              key={command}
              label={t((agv && AGV_WORDS[command]) || (`vc_${command}` as Word))}
              does={() => send({ command })}
              {...stopped(against(command))}
            />
          ))}
          {agv &&
            LIFTS.map((action) => (
              <Sure
                needs="POST /vehicles/{vehicle}/commands"
                key={action}
                label={t(`vc_lift_${action}`)}
                does={() => send({ command: "agv_lift", action })}
                {...stopped(against(`agv_lift ${action}`))}
              />
            ))}
          {agv && (
            <Sure
              needs="POST /vehicles/{vehicle}/commands"
              label={t(`vc_charge_${charge}`)}
              does={() => send({ command: "agv_charge", on: charge === "on" })}
              {...stopped(against(`agv_charge ${charge}`))}
            />
          )}
        </div>
        <div class="acts-row">
          <Sure needs="POST /vehicles/{vehicle}/park" label={t("park")} does={() => void asking.ask(() => post(`${path}/park`), t("sent"))} {...stopped(againstMove(vehicle, now))} />
        </div>
        <Move send={send} against={againstMove(vehicle, now)} />
        {agv && <AgvCommands send={send} against={against} />}
        {!agv && <Handle send={send} against={(station, pickup) => againstHandling(vehicle, station, pickup, now)} />}
        {!agv && <Display send={send} against={against("display")} />}
        <Told asking={asking} />
        <Service vehicle={vehicle} path={path} />
        <Past path={path} />
      </div>
    </details>
  );
}

/** Out of an alarm, step by step as far as each is safe; homing only when somebody has looked. */
export function Recover({ vehicle }: { vehicle: string }) {
  const path = `/vehicles/${encodeURIComponent(vehicle)}`;
  const asking = useAsking();
  const looked = useSignal(false);
  const now = vehicleNow(vehicle);
  const against = now ? againstRecovery(now, around()) : null;
  return (
    <div class="stack">
      <label class="tick">
        <input type="checkbox" checked={looked.value} onChange={(event) => (looked.value = event.currentTarget.checked)} />{" "}
        <span>{t("homing_safe")}</span>
      </label>
      <div class="acts-row">
        <Sure needs="POST /vehicles/{vehicle}/recover" label={t("recover")} does={() => void asking.ask(() => post(`${path}/recover`, { confirmed: looked.value }), t("sent"))} {...stopped(against)} />
      </div>
      <Told asking={asking} />
    </div>
  );
}

export type Send = (body: object) => void;

function Move({ send, against }: { send: Send; against: Against }) {
  const barcode = useSignal("");
  const action = useSignal<"stop" | "port" | "sbfl" | "sbfr">("stop");
  return (
    <div class="fields">
      <Field label={t("move_to")} value={barcode} list="barcode-names" />
      <Choice
        label={t("stop_action")}
        value={action}
        of={[
          ["stop", t("act_stop")],
          ["port", t("port")],
          ["sbfl", t("sbfl")],
          ["sbfr", t("sbfr")],
        ]}
      />
      <div class="wide acts-row">
        <Sure needs="POST /vehicles/{vehicle}/commands" label={t("move")} disabled={!barcode.value.trim()} does={() => send({ command: "move", barcode: barcode.value.trim(), action: action.value })} {...stopped(against)} />
      </div>
      <datalist id="barcode-names">
        {(layout.value?.points ?? []).slice(0, 2000).map(({ barcode: name }) => <option key={name} value={name} />)}
      </datalist>
    </div>
  );
}

function Handle({ send, against }: { send: Send; against: (station: string, pickup: boolean) => Against }) {
  const station = useSignal("");
  const place = station.value.trim();
  return (
    <div class="fields">
      <Field label={t("at_station")} value={station} list="station-names" />
      <div class="acts-row">
        <Sure needs="POST /vehicles/{vehicle}/commands" label={t("vc_pickup")} disabled={!place} does={() => send({ command: "pickup", station: place })} {...stopped(against(place, true))} />
        <Sure needs="POST /vehicles/{vehicle}/commands" label={t("vc_place")} disabled={!place} does={() => send({ command: "place", station: place })} {...stopped(against(place, false))} />
      </div>
      <datalist id="station-names">
        {layout.value?.stations.map(({ id }) => <option key={id} value={id} />)}
      </datalist>
    </div>
  );
}

function Display({ send, against }: { send: Send; against: Against }) {
  const words = useSignal("");
  return (
    <div class="fields">
      <Field label={t("display_text")} value={words} />
      <div class="acts-row">
        <Sure needs="POST /vehicles/{vehicle}/commands" label={t("vc_display")} disabled={!words.value} does={() => send({ command: "display", text: words.value })} {...stopped(against)} />
      </div>
    </div>
  );
}

/** Lockout while people are at it, and whether it is used at all. */
function Service({ vehicle, path }: { vehicle: Vehicle; path: string }) {
  const used = vehicle.service === "in_service";
  return (
    <Reasoned
      decisions={[
        vehicle.lockout
          ? { label: t("lift_lockout"), needs: "DELETE /vehicles/{vehicle}/lockout", bare: true, grave: true, does: () => call("DELETE", `${path}/lockout`) }
          : { label: t("lock_out"), needs: "POST /vehicles/{vehicle}/lockout", grave: true, does: (reason) => post(`${path}/lockout`, { reason }) },
        used
          ? { label: t("take_out"), needs: "PUT /vehicles/{vehicle}/service", grave: true, does: (reason) => call("PUT", `${path}/service`, { in_service: false, reason }) }
          : { label: t("put_back"), needs: "PUT /vehicles/{vehicle}/service", bare: true, does: () => call("PUT", `${path}/service`, { in_service: true }) },
      ]}
    />
  );
}

/** A command by its button's word, if it has one. */
export function commandName(kind: string): string {
  const word = `vc_${kind}`;
  return said(word) === word.replaceAll("_", " ") ? kind.replaceAll("_", " ") : said(word);
}

function Past({ path }: { path: string }) {
  const round = Math.floor(changes.vehicles.value / 30);
  const { value } = useRead<{ items: Command[] }>(`${path}/commands?limit=12`, round);
  return (
    <table class="bits">
      <tbody>
        {value?.items.map((command) => (
          <tr key={command.cmd_id} title={command.actor}>
            <th>{clock(command.opened)}</th>
            <td>{commandName(command.kind)}</td>
            <td>
              {said(`cs_${command.state}`)} <small class="calm">{tell(command.outcome)}</small>
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

