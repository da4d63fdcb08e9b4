/** Alarms: what is wrong now with cause, remedy and who knows of it; what was; what they add up to. */
import { useSignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import type { Wrong } from "../alarms";
import { post, serverNow } from "../api";
import { counted, none } from "../known";
import { clock } from "../shows";
import { alarmList, changes, selected, troubles, vehicles, devices, drives } from "../store";
import { said, t, tell } from "../texts";
import type { Alarm, AlarmCount } from "../types";
import { AlarmHistory } from "./AlarmHistory";
import { useRead } from "./asking";
import { Name } from "./Name";
import { Reasoned } from "./Reasoned";
import { Reliability } from "./Reliability";
import { Recover } from "./VehicleCommands";

type Tab = "now" | "history" | "pareto" | "reliability";
const TABS: Tab[] = ["now", "history", "pareto", "reliability"];

export function Alarms() {
  const tab = useSignal<Tab>("now");
  /** Whose alarms the history is to show; "": everybody's. */
  const source = useSignal("");
  return (
    <section class="room" aria-label={t("alarms")}>
      <div class="head">
        <h2>
          {t("alarms")} {counted(alarmList.value.length)}
        </h2>
        <span class="tabs">
          {TABS.map((name) => (
            <button type="button" key={name} aria-pressed={tab.value === name} onClick={() => (tab.value = name)}>
              {name === "reliability" ? t(name) : t(`alarms_${name}`)}
            </button>
          ))}
        </span>
      </div>
      {tab.value === "now" && <Present />}
      {tab.value === "history" && <AlarmHistory source={source} />}
      {tab.value === "pareto" && <Pareto />}
      {tab.value === "reliability" && (
        <Reliability
          show={(id) => {
            source.value = id;
            tab.value = "history";
          }}
        />
      )}
    </section>
  );
}

function Present() {
  const told = new Set(alarmList.value.map(({ source }) => source));
  const others = troubles.value.filter((wrong) => !told.has(wrong.source));
  return (
    <ul class="scroll alarms" tabIndex={0} aria-label={t("alarms_now")}>
      {alarmList.value.length + others.length === 0 && <li class="nothing">{none(t("no_alarms"))}</li>}
      {alarmList.value.map((alarm) => (
        <Line key={alarm.id} alarm={alarm} />
      ))}
      {others.map((wrong) => (
        <Other key={wrong.key} wrong={wrong} />
      ))}
    </ul>
  );
}

const GRAVE = new Set(["vehicle", "device", "drive", "traffic", "plant"]);

function Line({ alarm }: { alarm: Alarm }) {
  const grave = GRAVE.has(alarm.kind);
  const known = vehicles.has(alarm.source) || devices.has(alarm.source) || drives.has(alarm.source);
  return (
    <li data-alarm={`${alarm.kind} ${alarm.source}`}>
      <span class={`sign ${grave ? "" : "wait"}`} title={said(alarm.kind)}>
        {grave ? "!" : "‖"}
      </span>
      <span>
        <b>{known ? <Name id={alarm.source} /> : alarm.source}</b> {tell(alarm.cause)}{" "}
        <small class="calm">
          · {clock(alarm.begun)} · {said(alarm.kind)}
        </small>
      </span>
      {alarm.remedy && <p class="remedy">{tell(alarm.remedy)}</p>}
      <div class="wide">
        {alarm.kind === "vehicle" && vehicles.get(alarm.source)?.oper === "alarm" && <Recover vehicle={alarm.source} />}
        {alarm.acknowledged ? (
          <small class="good">
            ✓ {t("known_to", alarm.acknowledged_by ?? "", clock(alarm.acknowledged))} {alarm.note}
          </small>
        ) : (
          <Reasoned
            hint={t("note")}
            decisions={[{ label: t("acknowledge"), needs: "POST /alarms/{alarm}/acknowledge", bare: true, noted: true, does: (note) => post(`/alarms/${alarm.id}/acknowledge`, { note }) }]}
          />
        )}
      </div>
    </li>
  );
}

/** What the page itself sees to be wrong and the server keeps no alarm for: lockouts, say. */
function Other({ wrong }: { wrong: Wrong }) {
  const { kind, source } = wrong;
  return (
    <li data-alarm={wrong.key}>
      <span class={`sign ${wrong.grave ? "" : "wait"}`}>{wrong.grave ? "!" : "‖"}</span>
      <span>
        {kind === "controller" ? (
          <b>{t("controller")}</b>
        ) : (
          <button type="button" class="text" onClick={() => (selected.value = { kind, id: source })}>
            <b>{source}</b>
          </button>
        )}{" "}
        {tell(wrong.cause)} {wrong.since && <small class="calm">· {clock(wrong.since)}</small>}
      </span>
      {wrong.remedy && <p class="remedy">{tell(wrong.remedy)}</p>}
    </li>
  );
}

/** Counted over so much, s. */
const PARETO = { shift: 8 * 3600, day: 86_400, week: 7 * 86_400, month: 30 * 86_400 } as const;

function Pareto() {
  const by = useSignal<"code" | "source" | "both">("code");
  const period = useSignal<keyof typeof PARETO>("week");
  const round = changes.alarms.value;
  const from = useMemo(() => new Date(serverNow() - PARETO[period.value] * 1000).toISOString(), [period.value, round]);
  const { value } = useRead<{ items: AlarmCount[] }>(`/alarms/pareto?by=${by.value}&from=${from}`, round);
  let sum = 0;
  return (
    <div class="scroll" tabIndex={0} role="group" aria-label={t("alarms_pareto")}>
      <div class="padded acts-row">
        {(["code", "source", "both"] as const).map((name) => (
          <button type="button" key={name} aria-pressed={by.value === name} onClick={() => (by.value = name)}>
            {t(`pareto_${name}`)}
          </button>
        ))}
        <select aria-label={t("stretch")} class="narrow" value={period.value} onChange={(event) => (period.value = event.currentTarget.value as "week")}>
          {(Object.keys(PARETO) as (keyof typeof PARETO)[]).map((name) => (
            <option key={name} value={name}>
              {t(`period_${name}`)}
            </option>
          ))}
        </select>
      </div>
      <table class="list">
        <tbody>
          {value?.items.map((row) => {
            sum += row.share;
            return (
              <tr key={`${row.kind}${row.source}${row.code}`}>
                <td>{row.kind ? said(row.kind) : ""}</td>
                <td>{[row.source, row.code && tell(row.code)].filter(Boolean).join(" · ")}</td>
                <td class="number">{row.times}</td>
                <td class="number">{row.minutes.toFixed(1)} min</td>
                <td class="bar">
                  <i style={{ width: `${row.share * 100}%` }} />
                </td>
                <td class="number">{Math.round(sum * 100)} %</td>
              </tr>
            );
          })}
        </tbody>
      </table>
      {!value?.items.length && <p class="nothing">{none(t(value ? "no_alarms_yet" : "loading"))}</p>}
    </div>
  );
}
