/** Teaching: sessions, what they propose and what that would change, drift, and what a vehicle would be sent at a port. */
import { useSignal } from "@preact/signals";
import { post } from "../api";
import { clock } from "../shows";
import { changes, layout } from "../store";
import { none } from "../known";
import { said, t, tell } from "../texts";
import type { Axes, Drifted, Proposal, ProposalDetail, SessionDetail, TeachingSession, TaughtTarget } from "../types";
import { Field, Told, useAsking, useRead } from "./asking";
import { Button } from "./Button";
import { Name } from "./Name";
import { Fact } from "./Panel";
import { Changes, Pulses } from "./Pulses";
import { Reasoned } from "./Reasoned";
import { Table } from "./Table";
import { TeachingFiles } from "./TeachingFiles";
import { TeachingRaw } from "./TeachingRaw";

type Tab = "proposals" | "sessions" | "drift" | "dry_run" | "files" | "raw";
const TABS: Tab[] = ["proposals", "sessions", "drift", "dry_run", "files", "raw"];

export function Teaching() {
  const tab = useSignal<Tab>("proposals");
  return (
    <section class="room" aria-label={t("teaching")}>
      <div class="head">
        <h2>{t("teaching")}</h2>
        <span class="tabs">
          {TABS.map((name) => (
            <button type="button" key={name} aria-pressed={tab.value === name} onClick={() => (tab.value = name)}>
              {t(name === "files" || name === "raw" ? `teaching_${name}` : name)}
            </button>
          ))}
        </span>
      </div>
      {tab.value === "proposals" && <Proposals />}
      {tab.value === "sessions" && <Sessions />}
      {tab.value === "drift" && <Drift />}
      {tab.value === "dry_run" && <DryRun />}
      {tab.value === "files" && <TeachingFiles />}
      {tab.value === "raw" && <TeachingRaw />}
    </section>
  );
}

const OPEN = new Set(["collecting", "ready", "incomplete", "out_of_range", "wrong_mode", "pending", "ambiguous"]);
const tone = (state: string): string => (state === "approved" ? "good" : state === "rejected" ? "calm" : OPEN.has(state) ? "wait" : "");

function Proposals() {
  const chosen = useSignal<number | null>(null);
  const { value } = useRead<{ items: Proposal[] }>("/teaching/proposals?limit=200", changes.teaching.value);
  const id = chosen.value ?? value?.items[0]?.id ?? null;
  return (
    <div class="split">
      <Table
        label={t("proposals")}
        rows={value?.items}
        keyOf={(row) => String(row.id)}
        pick={(row) => (chosen.value = row.id)}
        chosen={String(id)}
        none={t("no_proposals")}
        columns={[
          { name: "#", by: (row) => row.id, of: (row) => row.id, number: true },
          { name: t("state"), by: (row) => row.state, of: (row) => <span class={`state ${tone(row.state)}`}>{said(row.state)}</span> },
          { name: t("kind"), by: (row) => row.side, of: (row) => t(row.side) },
          { name: t("at_station"), by: (row) => row.station, of: (row) => <Name id={row.station} /> },
          { name: t("vehicle"), by: (row) => row.vehicle, of: (row) => <Name id={row.vehicle} /> },
          { name: t("new"), of: (row) => <Pulses axes={row.result} /> },
          { name: t("when"), by: (row) => row.at, of: (row) => clock(row.at) },
        ]}
      />
      {id === null ? <p class="nothing">{none(t("choose_proposal"))}</p> : <Detail key={id} id={id} />}
    </div>
  );
}

/** A proposal: what was sent, what it would make, for whom that changes anything; and the decision. */
function Detail({ id }: { id: number }) {
  const again = useSignal(0);
  const { value: proposal } = useRead<ProposalDetail>(`/teaching/proposals/${id}`, changes.teaching.value, again.value);
  const station = useSignal("");
  const asking = useAsking();
  if (!proposal) return <div />;
  const path = `/teaching/proposals/${id}`;
  const match = { "If-Match": `"${proposal.revision}"` };
  const over = proposal.closed !== null;
  const against = ["incomplete", "wrong_mode", "out_of_range"].includes(proposal.state) ? [proposal.state] : [];
  const decide = (verb: string, body: object) => async (reason: string): Promise<void> => {
    await post(`${path}/${verb}`, { ...body, reason }, match);
    again.value++;
  };
  return (
    <div class="stack padded" data-proposal={id}>
      <h2 class="sub">
        {t(proposal.side)} · {proposal.station ?? "?"} · {proposal.vehicle}
      </h2>
      {proposal.why && (
        <p class="note waits">
          {tell(proposal.why)} <em>{tell(proposal.remedy)}</em>
        </p>
      )}
      {[...proposal.warnings, proposal.drift].filter(Boolean).map((words) => (
        <p key={words} class="note held">
          {tell(words)}
        </p>
      ))}
      <dl class="facts">
        <Fact name={t("sent_positions")}>
          <Pulses axes={proposal.raw} />
        </Fact>
        <Fact name={t("old")}>
          <Pulses axes={proposal.present} /> {proposal.present && <small>v{proposal.present.version}</small>}
        </Fact>
        <Fact name={t("new")}>
          <Pulses axes={proposal.result} before={proposal.present} />
        </Fact>
        {proposal.asked_by && <Fact name={t("asked_by")}>{proposal.asked_by}</Fact>}
        {over && (
          <Fact name={said(proposal.state)}>
            {proposal.closed_by} · {clock(proposal.closed ?? "")} {proposal.reason}
          </Fact>
        )}
      </dl>
      <Changes changes={proposal.changes} />
      {!over && proposal.state === "ambiguous" && (
        <div class="fields">
          <Field label={t("at_station")} value={station} list="station-names" />
          <div class="acts-row">
            <Button
              needs="POST /teaching/proposals/{proposal}/assign"
              disabled={!station.value}
              onClick={() => void asking.ask(() => post(`${path}/assign`, { station: station.value.trim() }, match))}
            >
              {t("assign")}
            </Button>
          </div>
          <datalist id="station-names">{layout.value?.stations.map((one) => <option key={one.id} value={one.id} />)}</datalist>
        </div>
      )}
      {!over && (
        <Reasoned
          asking={asking}
          decisions={[
            { label: t(against.length ? "approve_anyway" : "approve"), needs: "POST /teaching/proposals/{proposal}/approve", bare: against.length === 0, grave: true, does: decide("approve", { accept: against }) },
            { label: t("reject"), needs: "POST /teaching/proposals/{proposal}/reject", does: decide("reject", {}) },
          ]}
        />
      )}
    </div>
  );
}

function Sessions() {
  const chosen = useSignal<number | null>(null);
  const station = useSignal("");
  const vehicle = useSignal("");
  const asking = useAsking();
  const { value } = useRead<{ items: TeachingSession[] }>("/teaching/sessions?limit=100", changes.teaching.value);
  const open = (event: Event): void => {
    event.preventDefault();
    void asking.ask(async () => {
      const made = await post<TeachingSession>("/teaching/sessions", { station: station.value.trim(), vehicle: vehicle.value.trim() });
      chosen.value = made.id;
    });
  };
  const ports = layout.value?.stations.filter(({ kind }) => kind === "port") ?? [];
  const hoists = layout.value?.vehicles.filter(({ kind }) => kind !== "agv") ?? [];
  return (
    <div class="split">
      <Table
        label={t("sessions")}
        rows={value?.items}
        keyOf={(row) => String(row.id)}
        pick={(row) => (chosen.value = row.id)}
        chosen={String(chosen.value)}
        none={t("no_sessions")}
        columns={[
          { name: "#", by: (row) => row.id, of: (row) => row.id, number: true },
          { name: t("state"), by: (row) => row.state, of: (row) => said(row.state) },
          { name: t("at_station"), by: (row) => row.station, of: (row) => <Name id={row.station} /> },
          { name: t("vehicle"), by: (row) => row.vehicle, of: (row) => <Name id={row.vehicle} /> },
          { name: t("who"), by: (row) => row.actor, of: (row) => row.actor },
          { name: t("when"), by: (row) => row.opened, of: (row) => clock(row.opened) },
        ]}
      />
      <div>
        <form class="stack padded" onSubmit={open}>
          <h2 class="sub">{t("teach_port")}</h2>
          <div class="fields">
            <Field label={t("port")} name="station" value={station} list="port-names" required />
            <Field label={t("vehicle")} name="vehicle" value={vehicle} list="hoist-names" required />
          </div>
          <datalist id="port-names">{ports.map(({ id }) => <option key={id} value={id} />)}</datalist>
          <datalist id="hoist-names">{hoists.map(({ id }) => <option key={id} value={id} />)}</datalist>
          <div class="acts-row">
            <Button needs="POST /teaching/sessions" type="submit">
              {t("open_session")}
            </Button>
          </div>
          <Told asking={asking} />
        </form>
        {chosen.value !== null && <Session key={chosen.value} id={chosen.value} />}
      </div>
    </div>
  );
}

function Session({ id }: { id: number }) {
  const { value: session } = useRead<SessionDetail>(`/teaching/sessions/${id}`, changes.teaching.value, Math.floor(changes.vehicles.value / 20));
  const asking = useAsking();
  if (!session) return null;
  const path = `/teaching/sessions/${id}`;
  return (
    <div class="stack padded" data-session={id}>
      <h2 class="sub">
        #{id} {session.station} · {session.vehicle} · {said(session.state)}
      </h2>
      <p class="note waits">{tell(session.advice)}</p>
      {session.state === "open" && (
        <>
          <div class="acts-row">
            {(["dest", "offset"] as const).map((what) => (
              <Button
                needs="POST /teaching/sessions/{session}/start"
                key={what}
                onClick={() => void asking.ask(() => post(`${path}/start`, { what }), t("sent"))}
              >
                {t(what === "dest" ? "teach_dest" : "teach_offset")}
              </Button>
            ))}
          </div>
          <Reasoned
            asking={asking}
            decisions={[
              { label: t("close_session"), needs: "POST /teaching/sessions/{session}/close", bare: true, does: (reason) => post(`${path}/close`, { reason }) },
              { label: t("abandon"), needs: "POST /teaching/sessions/{session}/close", bare: true, grave: true, does: (reason) => post(`${path}/close`, { reason, abandon: true }) },
            ]}
          />
        </>
      )}
      {session.proposals.map((proposal) => (
        <p key={proposal.id}>
          #{proposal.id} {said(proposal.state)} <Pulses axes={proposal.result} />
        </p>
      ))}
    </div>
  );
}

function Drift() {
  const { value } = useRead<{ items: Drifted[] }>("/teaching/drift", changes.teaching.value);
  return (
    <Table
      label={t("drift")}
      rows={value?.items}
      keyOf={(row) => row.side + row.name}
      none={t("no_drift")}
      columns={[
        { name: t("kind"), by: (row) => row.side, of: (row) => t(row.side) },
        { name: t("name"), by: (row) => row.name, of: (row) => <Name id={row.name} /> },
        { name: t("old"), of: (row) => <Pulses axes={row.old} /> },
        { name: t("new"), of: (row) => <Pulses axes={row.new} before={row.old as Axes} /> },
        { name: t("drift"), of: (row) => tell(row.drift) },
      ]}
    />
  );
}

/** What a vehicle would be sent at a port, and from which rows; nothing is sent. */
function DryRun() {
  const station = useSignal("");
  const vehicle = useSignal("");
  const ready = layout.value?.stations.some(({ id }) => id === station.value) && layout.value.vehicles.some(({ id }) => id === vehicle.value);
  const path = `/teaching/targets/${encodeURIComponent(station.value)}/${encodeURIComponent(vehicle.value)}`;
  const { value } = useRead<TaughtTarget>(ready ? path : null, changes.teaching.value);
  return (
    <div class="stack padded">
      <div class="fields">
        <Field label={t("port")} name="station" value={station} list="dry-ports" />
        <Field label={t("vehicle")} name="vehicle" value={vehicle} list="dry-hoists" />
      </div>
      <datalist id="dry-ports">{layout.value?.stations.filter(({ kind }) => kind === "port").map(({ id }) => <option key={id} value={id} />)}</datalist>
      <datalist id="dry-hoists">{layout.value?.vehicles.filter(({ kind }) => kind !== "agv").map(({ id }) => <option key={id} value={id} />)}</datalist>
      {ready && value && (
        <dl class="facts">
          <Fact name={t("target")}>
            <Pulses axes={value} />
          </Fact>
          <Fact name={t("dest")}>
            <Pulses axes={value.dest} /> {value.dest && <small>v{value.dest.version}</small>}
          </Fact>
          <Fact name={t("offset")}>
            {value.reference ? t("reference_vehicle") : <Pulses axes={value.offset} />} {value.offset && <small>v{value.offset.version}</small>}
          </Fact>
          {value.refusal && (
            <Fact name={t("refused")}>
              <span class="bad">{tell(value.refusal)}</span>
            </Fact>
          )}
        </dl>
      )}
    </div>
  );
}
