/** What is wrong now, one row for each cause: acknowledged at once, and the vehicles held for it released together. */
import { useSignal } from "@preact/signals";
import { post } from "../api";
import { type Group, releasable } from "../groups";
import { clock } from "../shows";
import { changes, NATURAL, vehicles } from "../store";
import { said, t, tell } from "../texts";
import type { Alarm } from "../types";
import { Name } from "./Name";
import { type Decision, Reasoned } from "./Reasoned";
import { Recover } from "./VehicleCommands";

/** Kinds that stop something by themselves. */
const GRAVE = new Set(["vehicle", "device", "drive", "traffic", "plant"]);
/** Names that a closed row tells. */
const NAMED = 12;

export function AlarmGroup({ group }: { group: Group }) {
  const [only] = group.alarms;
  return group.alarms.length === 1 && only ? <Line alarm={only} /> : <Together group={group} />;
}

function Sign({ kind }: { kind: string }) {
  const grave = GRAVE.has(kind);
  return (
    <span class={`sign ${grave ? "" : "wait"}`} title={said(kind)}>
      {grave ? "!" : "‖"}
    </span>
  );
}

function Line({ alarm }: { alarm: Alarm }) {
  return (
    <li data-alarm={`${alarm.kind} ${alarm.source}`}>
      <Sign kind={alarm.kind} />
      <span>
        <b>
          <Name id={alarm.source} />
        </b>{" "}
        {tell(alarm.cause)}{" "}
        <small class="calm">
          · {clock(alarm.begun)} · {said(alarm.kind)}
        </small>
      </span>
      {alarm.remedy && <p class="remedy">{tell(alarm.remedy)}</p>}
      <div class="wide">
        {alarm.kind === "vehicle" && vehicles.get(alarm.source)?.oper === "alarm" && <Recover vehicle={alarm.source} />}
        {alarm.acknowledged ? <Known alarm={alarm} /> : <AcknowledgeOne alarm={alarm} />}
      </div>
    </li>
  );
}

function Known({ alarm }: { alarm: Alarm }) {
  return (
    <small class="good">
      ✓ {t("known_to", alarm.acknowledged_by ?? "", clock(alarm.acknowledged ?? ""))} {alarm.note}
    </small>
  );
}

function AcknowledgeOne({ alarm }: { alarm: Alarm }) {
  const does = (note: string): Promise<unknown> => post(`/alarms/${alarm.id}/acknowledge`, { note });
  return <Reasoned hint={t("note")} decisions={[{ label: t("acknowledge"), needs: "POST /alarms/{alarm}/acknowledge", bare: true, noted: true, does }]} />;
}

/** Several of one cause: how many, which, since when; opened, each by itself. */
function Together({ group }: { group: Group }) {
  const open = useSignal(false);
  const { alarms } = group;
  const [kind, first] = [alarms[0]?.kind ?? "", alarms.at(-1)?.begun ?? ""];
  return (
    <li data-group={kind} data-count={alarms.length}>
      <Sign kind={kind} />
      <span>
        <b>{alarms.length} ×</b> {tell(group.cause)}{" "}
        <small class="calm">
          · {t("since", clock(first))} · {said(kind)}
        </small>
      </span>
      <p class="names">
        {alarms.slice(0, NAMED).map(({ id, source }) => (
          <Name key={id} id={source} />
        ))}
        {alarms.length > NAMED && <span class="calm">{t("and_more", alarms.length - NAMED)}</span>}
      </p>
      {group.remedy && <p class="remedy">{tell(group.remedy)}</p>}
      <div class="wide">
        <Decisions alarms={alarms} />
        <details open={open.value} onToggle={(event) => (open.value = event.currentTarget.open)}>
          <summary>{t("each_by_itself")}</summary>
          {open.value && (
            <ul class="alarms" aria-label={t("each_by_itself")}>
              {alarms.map((alarm) => (
                <Line key={alarm.id} alarm={alarm} />
              ))}
            </ul>
          )}
        </details>
      </div>
    </li>
  );
}

interface Outcome {
  name: string;
  /** What the server said against it; "": done. */
  against: string;
}

/** One note acknowledges all, one reason releases all that may be: each is asked for by itself, and answered so. */
function Decisions({ alarms }: { alarms: Alarm[] }) {
  const outcomes = useSignal<Outcome[]>([]);
  void changes.vehicles.value;
  const unknown = alarms.filter(({ acknowledged }) => !acknowledged);
  const held = [...new Set(alarms.map(({ source }) => source))].filter((id) => releasable(vehicles.get(id))).sort(NATURAL.compare);
  const acknowledge = async (note: string): Promise<void> => {
    const { items } = await post<{ items: { alarm: number; acknowledged: boolean; detail: string }[] }>("/alarms/acknowledge", { alarms: unknown.map(({ id }) => id), note });
    const named = new Map(alarms.map(({ id, source }) => [id, source]));
    outcomes.value = items.map(({ alarm, acknowledged, detail }) => ({ name: named.get(alarm) ?? `#${alarm}`, against: acknowledged ? "" : detail }));
  };
  const release = async (reason: string): Promise<void> => {
    outcomes.value = [];
    for (const name of held) {
      const failure = await post(`/vehicles/${encodeURIComponent(name)}/release`, { verdict: "go_on", reason }).then(
        () => "",
        (why: unknown) => (why instanceof Error ? why.message : String(why)),
      );
      outcomes.value = [...outcomes.value, { name, against: failure }];
    }
  };
  const decisions: Decision[] = [
    ...(unknown.length > 0
      ? [{ label: t("acknowledge_all", unknown.length), needs: "POST /alarms/acknowledge" as const, bare: true, noted: true, does: acknowledge }]
      : []),
    ...(held.length > 0 ? [{ label: t("release_all", held.length), needs: "POST /vehicles/{vehicle}/release" as const, grave: true, does: release }] : []),
  ];
  return (
    <>
      {unknown.length === 0 && <small class="good">✓ {t("all_acknowledged")}</small>}
      {decisions.length > 0 && <Reasoned hint={t("note_or_reason")} decisions={decisions} />}
      <Outcomes list={outcomes.value} />
    </>
  );
}

function Outcomes({ list }: { list: Outcome[] }) {
  const refused = list.filter(({ against }) => against);
  if (list.length === 0) return null;
  return (
    <div role="status" data-outcomes>
      <small class={refused.length ? "" : "good"}>{t("done_of", list.length - refused.length, list.length)}</small>
      {refused.map(({ name, against }) => (
        <p key={name} class="bad">
          {name}: {tell(against)}
        </p>
      ))}
    </div>
  );
}
