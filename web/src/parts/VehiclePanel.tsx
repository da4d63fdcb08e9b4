/** One vehicle: what it does and why not, its status bit by bit, its line, and the two decisions a person may take here. */
import { useSignal } from "@preact/signals";
import { namesItself } from "../access";
import { againstVerdict } from "../against";
import { actor, post, serverNow } from "../api";
import { stopped } from "../around";
import { clock, LOOKS, lookOf, span } from "../shows";
import { layout, selected, tick, vehicleList, vehicleNow } from "../store";
import { rootOf } from "../waiting";
import { said, t, tell, type Word } from "../texts";
import type { Agv, Vehicle } from "../types";
import { Missing } from "./Away";
import { Button } from "./Button";
import { Frames } from "./Frames";
import { Name } from "./Name";
import { Fact, Panel } from "./Panel";
import { Problem } from "./Problem";
import { Taught } from "./Taught";
import { Recover, VehicleCommands } from "./VehicleCommands";
import { doing } from "./Vehicles";

export function VehiclePanel({ id }: { id: string }) {
  const now = vehicleNow(id);
  void tick.value;
  if (!now) return <Missing id={id} />;
  const load = now.loaded === null ? t("unknown") : now.loaded ? (now.carrier ?? t("loaded")) : t("empty");
  return (
    <Panel title={now.id} tag={doing(now)} colour={LOOKS[lookOf(now)]}>
      <Notes vehicle={now} />
      {now.oper === "alarm" && <Recover vehicle={id} />}
      <dl>
        <Fact name={t("state")}>
          {said(now.state)} · {said(now.service)}
        </Fact>
        <Fact name={t("mode")}>
          {upper(now.mode)} · {upper(now.oper)}
          {now.code ? ` · ${hex(now.code)} ${now.code_name}` : ""}
        </Fact>
        <Fact name={t("carrier")}>{load}</Fact>
        <Fact name={t(lineOf(id) ? "tag" : "place")}>
          {now.barcode ?? t("unknown")}
          {now.dist ? ` + ${now.dist} mm` : ""}
        </Fact>
        <Fact name={t("job")}>{now.job ? <Name id={now.job} /> : t("none")}</Fact>
        <Fact name={t("goal")}>
          {now.goal ? (
            <button type="button" class="text" onClick={() => (selected.value = { kind: "station", id: now.goal as string })}>
              {now.goal}
            </button>
          ) : (
            t("none")
          )}
        </Fact>
      </dl>
      <Decide vehicle={now} />
      <VehicleCommands vehicle={now} />
      {now.agv ? <AgvFacts agv={now.agv} /> : <Bits vehicle={now} />}
      <LinkFacts vehicle={now} />
      {!now.agv && <Taught kind="vehicle" id={id} />}
      <Frames path={`/vehicles/${encodeURIComponent(id)}/frames`} />
    </Panel>
  );
}

/** The line that an AGV shares with others; null for a hoist. */
const lineOf = (id: string): string | null => layout.value?.vehicles.find((one) => one.id === id)?.link ?? null;
const upper = (word: string | null): string => (word === null ? "–" : word.toUpperCase());
const hex = (code: number): string => `0x${code.toString(16).toUpperCase().padStart(4, "0")}`;

/** Why it is locked out, held, or waits. */
export function Notes({ vehicle }: { vehicle: Vehicle }) {
  return (
    <>
      {vehicle.lockout && (
        <p class="note held">
          <b>{t("locked", vehicle.lockout.owner)}</b> {vehicle.lockout.reason}
        </p>
      )}
      {vehicle.hold && (
        <p class="note held">
          <b>{t("held_note")}</b> {tell(vehicle.hold.reason)} <em>{tell(vehicle.hold.remedy)}</em>
        </p>
      )}
      {vehicle.waiting && !vehicle.hold && (
        <p class="note waits">
          <b>{t("waits")}</b> {tell(vehicle.waiting)}
        </p>
      )}
      <Behind vehicle={vehicle} />
    </>
  );
}

/** Who is behind a chain of waits, and how many wait because of this one. */
function Behind({ vehicle }: { vehicle: Vehicle }) {
  const root = rootOf(vehicle, vehicleNow);
  const others = vehicleList.value.filter((other) => other.id !== vehicle.id && rootOf(other, vehicleNow)?.id === vehicle.id).length;
  return (
    <>
      {root && root.id !== vehicle.waits_for && (
        <p class="note waits" data-root={root.id}>
          <b>{t("behind_it")}</b> <Name id={root.id} /> {tell(root.hold?.reason ?? root.waiting)}
        </p>
      )}
      {others > 0 && <p class="note waits">{t("wait_behind", others)}</p>}
    </>
  );
}

function Bits({ vehicle }: { vehicle: Vehicle }) {
  return (
    <details open>
      <summary>
        {t(lineOf(vehicle.id) ? "status" : "status_bits")}
        {!lineOf(vehicle.id) && (
          <code>
            {vehicle.status1 ?? "–"} {vehicle.status2 ?? ""}
          </code>
        )}
      </summary>
      {vehicle.bits.length === 0 && <p class="nothing">{t("no_status")}</p>}
      <table class="bits">
        <tbody>
          {vehicle.bits.map((bit) => (
            <tr key={bit.name} data-bit={bit.name}>
              <th title={said(`bit_${bit.name}`)}>{bit.name.toUpperCase()}</th>
              <td>{bit.value}</td>
              <td>
                {meaningOf(bit)} <small class="calm">{said(`bit_${bit.name}`)}</small>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </details>
  );
}

/** A gripper's open and close are other words than a door's; what has no word is a number. */
function meaningOf({ name, meaning }: { name: string; meaning: string }): string {
  if (name === "grip" && (meaning === "open" || meaning === "close")) return said(`grip_${meaning}`);
  if (name === "oper" && meaning === "pause") return said("pause_oper");
  return said(meaning);
}

function AgvFacts({ agv }: { agv: Agv }) {
  const word = (name: string): string => said(`agv_${name}`);
  const flag = (on: boolean): string => t(on ? "yes" : "no");
  return (
    <section class="part">
      <h3>{t("status")}</h3>
      <dl>
        <Fact name={t("cart")}>{word(agv.cart)}</Fact>
        <Fact name={t("lift")}>{word(agv.lift)}</Fact>
        <Fact name={t("steering")}>{word(agv.steering)}</Fact>
        <Fact name={t("in_position")}>{flag(agv.in_position)}</Fact>
        <Fact name={t("charges_now")}>{flag(agv.charging)}</Fact>
        <Fact name={t("last_tag")}>{agv.tag}</Fact>
        {agv.toward && <Fact name={t("beyond")}>{agv.toward}</Fact>}
        <Fact name={t("path")}>{agv.path}</Fact>
      </dl>
    </section>
  );
}

function LinkFacts({ vehicle }: { vehicle: Vehicle }) {
  const { link } = vehicle;
  const line = lineOf(vehicle.id);
  return (
    <dl>
      <Fact name={t("link")}>
        <span class={link.up ? "good" : "bad"}>{t(link.up ? "link_up" : "link_down", clock(link.since))}</span>
        {!link.up && link.reason && <small> · {tell(link.reason)}</small>}
      </Fact>
      {!line && (
        <Fact name={t("round_trip")}>{link.round_trip_ms === null ? "–" : `${link.round_trip_ms.toFixed(1)} ms`}</Fact>
      )}
      <Fact name={t("frames_io")}>
        {link.frames_in} / {link.frames_out}
      </Fact>
      <Fact name={t("trouble_counts")}>
        {link.garbled} / {link.resends} / {link.duplicates}
      </Fact>
      <Fact name={t("seen")}>{vehicle.seen ? t("ago", span(serverNow() - Date.parse(vehicle.seen))) : "–"}</Fact>
      {line ? (
        <Fact name={t("on_line")}>{t("line_number", line, vehicle.dev_id)}</Fact>
      ) : (
        <Fact name={t("address")}>
          {vehicle.address} · DEV_ID {vehicle.dev_id} · {vehicle.dialect}
        </Fact>
      )}
    </dl>
  );
}

const VERDICTS = ["go_on", "off_rail", "stands_at"] as const;

/** Hold a vehicle; release one that is held or absent. Both want a reason, a release a name as well. */
function Decide({ vehicle }: { vehicle: Vehicle }) {
  const reason = useSignal("");
  const verdict = useSignal<(typeof VERDICTS)[number]>("go_on");
  const barcode = useSignal(vehicle.barcode ?? "");
  const error = useSignal<unknown>(null);
  const releasing = vehicle.hold !== null || vehicle.activity === "absent" || vehicle.activity === "off_rail";
  const against = releasing ? againstVerdict(vehicle, verdict.value) : null;
  const send = (event: Event): void => {
    event.preventDefault();
    error.value = null;
    const path = `/vehicles/${encodeURIComponent(vehicle.id)}/${releasing ? "release" : "hold"}`;
    const stands = verdict.value === "stands_at" ? { barcode: barcode.value.trim() } : {};
    const body = releasing ? { verdict: verdict.value, reason: reason.value, ...stands } : { reason: reason.value };
    post(path, body).then(
      () => (reason.value = ""),
      (failure: unknown) => (error.value = failure),
    );
  };
  return (
    <form class="decide" onSubmit={send}>
      {releasing && (
        <select
          aria-label={t("verdict")}
          value={verdict.value}
          onChange={(event) => (verdict.value = event.currentTarget.value as (typeof VERDICTS)[number])}
        >
          {VERDICTS.map((word) => (
            <option key={word} value={word} disabled={againstVerdict(vehicle, word) !== null}>
              {t(`verdict_${word}` as Word)}
            </option>
          ))}
        </select>
      )}
      {releasing && verdict.value === "stands_at" && (
        <input
          aria-label={t("barcode")}
          required
          value={barcode.value}
          onInput={(event) => (barcode.value = event.currentTarget.value)}
        />
      )}
      <input
        aria-label={t("reason")}
        placeholder={t("reason")}
        required
        maxLength={200}
        value={reason.value}
        onInput={(event) => (reason.value = event.currentTarget.value)}
      />
      <Button
        needs={releasing ? "POST /vehicles/{vehicle}/release" : "POST /vehicles/{vehicle}/hold"}
        type="submit"
        title={releasing && namesItself.value && !actor() ? t("your_name") : ""}
        {...stopped(against)}
      >
        {t(releasing ? "release" : "hold")}
      </Button>
      <Problem error={error.value} />
    </form>
  );
}
