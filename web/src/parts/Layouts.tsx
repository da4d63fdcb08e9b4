/** Versions of the plant: stage a file, see what differs and what it breaks, activate it, roll back. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { download, post, Refused, upload } from "../api";
import { moment } from "../shows";
import { layout, tick } from "../store";
import { none } from "../known";
import { said, t, tell } from "../texts";
import type { Break, Change, Difference, Finding, Impact, Version } from "../versions";
import { Field, Told, useAsking, useRead } from "./asking";
import { Button } from "./Button";
import { DifferenceMap } from "./DifferenceMap";
import { Problem } from "./Problem";
import { Reasoned } from "./Reasoned";
import { Table } from "./Table";

/** Asked so often, s. */
const EVERY = 2;
const TONE: Record<Version["state"], string> = { staged: "", awaited: "wait", active: "good", former: "calm", rejected: "bad" };

export function Layouts() {
  const chosen = useSignal<number | null>(null);
  const again = useSignal(0);
  const { value, error } = useRead<{ items: Version[] }>("/layout/versions?limit=200", again.value, Math.floor(tick.value / EVERY));
  const items = value?.items ?? [];
  const active = items.find(({ state }) => state === "active");
  const version = items.find(({ number }) => number === chosen.value);
  // The plan of the version that runs: read again once the controller has changed over.
  useEffect(() => {
    if (active && layout.value && layout.value.version !== active.number) location.reload();
  }, [active?.number]);
  return (
    <section class="room" aria-label={t("layouts")}>
      <div class="head">
        <h2>{t("layouts")}</h2>
      </div>
      <div class="split layouts">
        <div>
          <Table
            label={t("layouts")}
            rows={items}
            keyOf={(row) => String(row.number)}
            pick={(row) => (chosen.value = row.number)}
            chosen={String(chosen.value)}
            none={t("no_versions")}
            columns={[
              { name: "#", by: (row) => row.number, of: (row) => <Chosen version={row} pick={() => (chosen.value = row.number)} />, number: true },
              { name: t("state"), by: (row) => row.state, of: (row) => <b class={TONE[row.state]}>{t(`version_${row.state}`)}</b> },
              { name: t("at"), by: (row) => row.activated ?? row.at, of: (row) => moment(row.activated ?? row.at) },
              { name: t("actor"), by: (row) => row.activated_by ?? row.actor, of: (row) => tell(row.activated_by ?? row.actor) },
              { name: t("reason"), wraps: true, of: (row) => tell(row.why || row.reason) },
            ]}
          />
          <Problem error={error} />
          <Stage
            after={(number) => {
              chosen.value = number;
              again.value++;
            }}
          />
        </div>
        {!version && <p class="nothing">{none(t("choose_version"))}</p>}
        {version && <Detail key={version.number} version={version} active={active ?? null} after={() => again.value++} />}
      </div>
    </section>
  );
}

function Chosen({ version, pick }: { version: Version; pick: () => void }) {
  return (
    <button type="button" class="text" onClick={pick}>
      {version.number}
    </button>
  );
}

function Stage({ after }: { after: (number: number) => void }) {
  const reason = useSignal("");
  const file = useSignal<File | null>(null);
  const findings = useSignal<Finding[]>([]);
  const asking = useAsking();
  const send = async (event: Event): Promise<void> => {
    event.preventDefault();
    findings.value = [];
    await asking.ask(async () => {
      const text = await (file.value as File).text();
      const made = await upload<Version & { findings: Finding[] }>(
        `/layout/versions?${new URLSearchParams({ reason: reason.value.trim() })}`,
        text,
        "application/yaml",
      );
      findings.value = made.findings;
      file.value = null;
      reason.value = "";
      after(made.number);
    }, t("version_taken"));
    if (asking.error.value instanceof Refused) findings.value = asking.error.value.errors as unknown as Finding[];
  };
  return (
    <form class="stack padded" aria-label={t("stage_file")} onSubmit={(event) => void send(event)}>
      <h2 class="sub">{t("stage_file")}</h2>
      <div class="acts-row">
        <label class="file">
          <span>{file.value?.name ?? t("plant_file")}</span>
          <input type="file" accept=".yaml,.yml" aria-label={t("plant_file")} onChange={(event) => (file.value = event.currentTarget.files?.[0] ?? null)} />
        </label>
      </div>
      <Field label={t("reason")} name="reason" value={reason} wide />
      <div class="acts-row">
        <Button needs="POST /layout/versions" type="submit" disabled={asking.busy.value || !file.value || !reason.value.trim()}>
          {t("stage_file")}
        </Button>
      </div>
      <Told asking={asking} />
      <ul class="plain findings">
        {findings.value.map((one) => (
          <li key={`${one.line}:${one.column} ${one.message}`} class={one.severity === "error" ? "bad" : "wait"}>
            {one.line}:{one.column} {tell(one.message)}
            {one.remedy && <small class="calm"> {tell(one.remedy)}</small>}
          </li>
        ))}
      </ul>
    </form>
  );
}

function Detail({ version, active, after }: { version: Version; active: Version | null; after: () => void }) {
  const path = `/layout/versions/${version.number}`;
  const runs = version.state === "active";
  const compared = !runs && !version.pruned;
  const change = useRead<Difference>(compared ? `${path}/diff` : null, active?.number);
  const impact = useRead<Impact>(compared ? `${path}/impact` : null, active?.number, Math.floor(tick.value / EVERY));
  const asking = useAsking();
  const activate = (wait: boolean) => async (reason: string) => {
    await post(`${path}/activate`, { reason, wait, instead_of: active?.number ?? null });
    after();
  };
  const reject = async (reason: string): Promise<void> => {
    await post(`${path}/reject`, { reason });
    after();
  };
  const label = version.state === "former" ? t("roll_back_to") : t("activate");
  const ready = impact.value?.ready ?? false;
  const decisions = [
    { label, needs: "POST /layout/versions/{version}/activate" as const, grave: true, does: activate(false) },
    ...(ready ? [] : [{ label: t("activate_later"), needs: "POST /layout/versions/{version}/activate" as const, grave: true, does: activate(true) }]),
  ];
  const rejecting = { label: t(version.state === "awaited" ? "take_back" : "reject"), needs: "POST /layout/versions/{version}/reject" as const, does: reject };
  const open = version.state === "staged" || version.state === "former";
  return (
    <section class="stack padded" data-version={version.number} aria-label={`${t("version")} ${version.number}`}>
      <h2 class="sub">
        {t("version")} {version.number} · <b class={TONE[version.state]}>{t(`version_${version.state}`)}</b>
      </h2>
      <p>
        {version.actor} · {moment(version.at)} · {version.reason}
      </p>
      {version.note && <p class="note held">{tell(version.note)}</p>}
      {version.pruned && <p class="note">{t("text_not_kept")}</p>}
      {version.state === "awaited" && <p class="note">{t("jobs_refused_meanwhile")}</p>}
      {!version.pruned && (
        <div class="acts-row">
          <button type="button" onClick={() => void asking.ask(() => download(`${path}/file`, `${layout.value?.name ?? "plant"}-${version.number}.yaml`), "")}>
            {t("save_file")}
          </button>
        </div>
      )}
      <Told asking={asking} />
      {open && <Reasoned decisions={version.state === "staged" ? [...decisions, rejecting] : decisions} />}
      {version.state === "awaited" && <Reasoned decisions={[rejecting]} />}
      {compared && <Weighed impact={impact.value} error={impact.error} />}
      {compared && <Changes difference={change.value} error={change.error} />}
    </section>
  );
}

function Weighed({ impact, error }: { impact: Impact | null; error: unknown }) {
  if (!impact) return <Problem error={error} />;
  return (
    <>
      <h3>{t("in_the_way")}</h3>
      {impact.ready ? <p class="good">{t("nothing_in_the_way")}</p> : <Breaks list={impact.in_the_way} tone="bad" />}
      {impact.lost.length > 0 && <h3>{t("lost_with_it")}</h3>}
      <Breaks list={impact.lost} tone="wait" />
      {impact.lacking.length > 0 && <h3>{t("lacking_with_it")}</h3>}
      <Breaks list={impact.lacking} tone="wait" />
    </>
  );
}

function Breaks({ list, tone }: { list: Break[]; tone: string }) {
  return (
    <ul class="plain findings">
      {list.map((one) => (
        <li key={`${one.what} ${one.name} ${one.text}`}>
          <b class={tone}>
            {said(one.what)} {one.name}
          </b>
          : {tell(one.text)}
          {one.remedy && <small class="calm"> {tell(one.remedy)}</small>}
        </li>
      ))}
    </ul>
  );
}

function Changes({ difference, error }: { difference: Difference | null; error: unknown }) {
  if (!difference) return <Problem error={error} />;
  const keyOf = (row: Change): string => `${row.what} ${row.name} ${row.how} ${row.text}`;
  return (
    <>
      <h3>
        {t("what_differs")} {difference.against} → {difference.version}
      </h3>
      {difference.changes.length > 0 && <DifferenceMap changes={difference.changes} />}
      <Table
        label={t("what_differs")}
        rows={difference.changes}
        keyOf={keyOf}
        none={t("no_difference")}
        columns={[
          { name: t("what"), by: (row) => row.what, of: (row) => said(row.what) },
          { name: t("name"), by: (row) => row.name, of: (row) => row.name },
          { name: t("how"), by: (row) => row.how, of: (row) => <b class={`how ${row.how}`}>{t(`diff_${row.how}`)}</b> },
          { name: t("in_words"), wraps: true, of: (row) => tell(row.text) },
        ]}
      />
      <Breaks list={difference.breaks} tone="wait" />
    </>
  );
}
