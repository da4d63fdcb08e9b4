/** Alarms: what is wrong now with cause, remedy and who knows of it; what was; what they add up to. */
import { useSignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import type { Wrong } from "../alarms";
import { serverNow } from "../api";
import { groupsOf } from "../groups";
import { counted, none } from "../known";
import { clock } from "../shows";
import { alarmCount, alarmList, alongside, changes, selected, unacknowledged } from "../store";
import { said, t, tell } from "../texts";
import type { AlarmCount } from "../types";
import { AlarmGroup } from "./AlarmGroups";
import { AlarmHistory } from "./AlarmHistory";
import { useRead } from "./asking";
import { Reliability } from "./Reliability";

type Tab = "now" | "history" | "pareto" | "reliability";
const TABS: Tab[] = ["now", "history", "pareto", "reliability"];

export function Alarms() {
  const tab = useSignal<Tab>("now");
  /** Whose alarms the history is to show; "": everybody's. */
  const source = useSignal("");
  return (
    <section class="room" aria-label={t("alarms")}>
      <div class="head">
        <h2 title={t("alarm_count_title", unacknowledged.value)}>
          {t("alarms")} {counted(alarmCount.value)}
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
  const others = alongside.value;
  const barred = others.filter(({ grave }) => !grave);
  return (
    <ul class="scroll alarms" tabIndex={0} aria-label={t("alarms_now")}>
      {alarmCount.value === 0 && <li class="nothing">{none(t("no_alarms"))}</li>}
      {others.filter(({ grave }) => grave).map((wrong) => (
        <Other key={wrong.key} wrong={wrong} />
      ))}
      {groupsOf(alarmList.value).map((group) => (
        <AlarmGroup key={group.key} group={group} />
      ))}
      {barred.length > 0 && (
        <li class="sub" title={t("no_alarms_but_title")}>
          {t("no_alarms_but", barred.length)}
        </li>
      )}
      {barred.map((wrong) => (
        <Other key={wrong.key} wrong={wrong} />
      ))}
    </ul>
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
