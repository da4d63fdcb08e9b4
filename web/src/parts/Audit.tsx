/** The audit: who asked for what, looked for by name, deed, object, outcome and time; whether its chain is whole; as a file. */
import { useSignal } from "@preact/signals";
import { refusal, round } from "../access";
import { get } from "../api";
import { csvOf, save } from "../csv";
import { FIELDS, fieldsOf } from "../details";
import { moment } from "../shows";
import { language, said, t, tell } from "../texts";
import { Choice, Field, Told, useAsking, useRead } from "./asking";
import { Button } from "./Button";
import { Table } from "./Table";
import { commandName } from "./VehicleCommands";

interface Row {
  seq: number;
  at: string;
  actor: string;
  action: string;
  target: string;
  detail: string;
  accepted: boolean;
}

interface Check {
  rows: number;
  last: number;
  hash: string;
  broken: number | null;
  reason: string;
  next: number | null;
}

const PAGE = 100;
/** Most rows of one file. Our choice: a browser holds them all. */
const MOST = 100_000;
const COLUMNS: (keyof Row)[] = ["seq", "at", "actor", "action", "target", "detail", "accepted"];

type Outcome = "" | "true" | "false";

function queryOf(given: Record<string, string>): string {
  const query = new URLSearchParams({ order: "newest" });
  for (const [name, value] of Object.entries(given)) if (value.trim()) query.set(name, value.trim());
  return query.toString();
}

/** What a field for date and time has, as the server wants it. */
function whenOf(local: string): string {
  const at = new Date(local);
  return local && !Number.isNaN(at.getTime()) ? at.toISOString() : "";
}

export function Audit() {
  const why = refusal("GET /audit");
  return (
    <section class="room" aria-label={t("audit")}>
      <div class="head">
        <h2>{t("audit")}</h2>
        {!why && <Chain />}
      </div>
      {why ? <p class="nothing">{why}</p> : <Rows />}
    </section>
  );
}

/** Whether each row follows from the one before it. */
function Chain() {
  const found = useSignal<Check | null>(null);
  const rows = useSignal(0);
  const asking = useAsking();
  const check = (): void =>
    void asking.ask(async () => {
      found.value = null;
      rows.value = 0;
      let after: number | null = 0;
      while (after !== null) {
        const part: Check = await get<Check>(`/audit/check?after=${after}`);
        rows.value += part.rows;
        after = part.next;
        if (after === null) found.value = part;
      }
    }, "");
  const now = found.value;
  return (
    <>
      {now && (
        <span class={now.broken === null ? "good" : "bad"} role="status" data-chain={now.broken === null ? "whole" : "broken"} title={now.hash}>
          {now.broken === null ? t("chain_whole", rows.value, now.last, now.hash.slice(0, 12)) : t("chain_broken", now.broken, tell(now.reason))}
        </span>
      )}
      {asking.busy.value && <span role="status">{t("chain_looking", rows.value)}</span>}
      <Told asking={asking} />
      <Button needs="GET /audit/check" disabled={asking.busy.value} onClick={check}>
        {t("check_chain")}
      </Button>
    </>
  );
}

function Rows() {
  const [actor, action, target, begin, end] = [useSignal(""), useSignal(""), useSignal(""), useSignal(""), useSignal("")];
  const accepted = useSignal<Outcome>("");
  const query = useSignal(queryOf({}));
  /** Where each page begins; the last is the one that is shown. */
  const pages = useSignal<number[]>([0]);
  const asking = useAsking();
  const again = useSignal(0);
  const after = pages.value.at(-1) ?? 0;
  const path = `/audit?${query.value}&limit=${PAGE}${after ? `&after=${after}` : ""}`;
  const { value } = useRead<{ items: Row[]; next: number | null }>(path, again.value, round.value);
  const look = (event: Event): void => {
    event.preventDefault();
    query.value = queryOf({
      actor: actor.value,
      action: action.value,
      target: target.value,
      accepted: accepted.value,
      from: whenOf(begin.value),
      to: whenOf(end.value),
    });
    pages.value = [0];
    again.value++;
  };
  const write = (): void =>
    void asking.ask(async () => {
      const rows: Row[] = [];
      let from: number | null = 0;
      while (from !== null && rows.length < MOST) {
        const page: { items: Row[]; next: number | null } = await get(`/audit?${query.value}&limit=1000${from ? `&after=${from}` : ""}`);
        rows.push(...page.items);
        from = page.next;
      }
      save(csvOf(COLUMNS, rows), "audit.csv");
    }, "");
  return (
    <div class="filtered">
      <form class="filters" role="search" aria-label={t("audit")} onSubmit={look}>
        <Field label={t("who")} name="actor" value={actor} />
        <Field label={t("what")} name="action" value={action} list="audit-actions" />
        <Field label={t("on_what")} name="target" value={target} />
        <Choice
          label={t("result")}
          value={accepted}
          of={[
            ["", t("all")],
            ["true", t("carried_out")],
            ["false", t("refused")],
          ]}
        />
        <Field label={t("since_when")} name="from" type="datetime-local" value={begin} />
        <Field label={t("until_when")} name="to" type="datetime-local" value={end} />
        <button type="submit" class="primary">
          {t("find")}
        </button>
        <button type="button" disabled={asking.busy.value} onClick={write}>
          {t("save_csv")}
        </button>
        <datalist id="audit-actions">{[...new Set(value?.items.map((row) => row.action))].map((name) => <option key={name} value={name} />)}</datalist>
        <Told asking={asking} />
      </form>
      <Table
        label={t("audit")}
        rows={value?.items}
        keyOf={(row) => String(row.seq)}
        none={t("no_rows")}
        columns={[
          { name: "#", of: (row) => row.seq, number: true },
          { name: t("when"), of: (row) => moment(row.at) },
          { name: t("who"), of: (row) => tell(row.actor) },
          { name: t("what"), of: (row) => <Did action={row.action} /> },
          { name: t("on_what"), of: (row) => tell(row.target) },
          { name: t("result"), of: (row) => <span class={row.accepted ? "good" : "bad"}>{t(row.accepted ? "carried_out" : "refused")}</span> },
          { name: t("in_words"), wraps: true, of: (row) => inWords(row.detail) },
        ]}
      />
      <div class="padded acts-row">
        <button type="button" disabled={pages.value.length < 2} onClick={() => (pages.value = pages.value.slice(0, -1))}>
          ◀ {t("newer_rows")}
        </button>
        <span class="calm">{t("page_number", pages.value.length)}</span>
        <button
          type="button"
          disabled={!value?.next}
          onClick={() => value?.next && (pages.value = [...pages.value, value.next])}
        >
          {t("older_rows")} ▶
        </button>
      </div>
    </div>
  );
}

/** What a row says besides, in the reader's language: a sentence by its pattern, a request field by field. */
function inWords(detail: string): string {
  const told = tell(detail);
  if (language.value === "en" || told !== detail) return told;
  const value = (field: string, text: string): string => (field === "what" || field === "act" ? commandName(text) : text === "True" ? t("yes") : said(text));
  return fieldsOf(detail)?.map(([field, text]) => `${t(FIELDS[field])}: ${NAMED.has(field) ? text : value(field, text)}`).join(" · ") ?? detail;
}

/** What people or the plant file have named is not translated. */
const NAMED = new Set(["vehicle", "station", "stations", "drive", "device", "job", "carrier", "place", "zone", "source", "destination", "reason", "note", "barcode", "tag", "idempotency_key", "fallbacks", "text", "other", "model", "url"]);

/** What was asked for in words, and by the name that it is looked for by. */
function Did({ action }: { action: string }) {
  const word = said(`did_${action}`);
  const named = word !== `did ${action}`;
  return (
    <>
      {named && <>{word} </>}
      <small class={named ? "calm technical" : "calm"}>{action}</small>
    </>
  );
}
