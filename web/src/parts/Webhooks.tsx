/** Webhooks: who is told of events by HTTP, how far each is, what was tried; paused, tried, told again, given another secret. */
import { useSignal } from "@preact/signals";
import { refusal } from "../access";
import { call, post } from "../api";
import { moment } from "../shows";
import { tick } from "../store";
import { happening, said, t, tell } from "../texts";
import { Field, Told, useAsking, useRead } from "./asking";
import { Button } from "./Button";
import { Once } from "./Once";
import { Fact } from "./Panel";
import { Sure } from "./Sure";
import { Table } from "./Table";

interface Webhook {
  id: number;
  url: string;
  events: string[];
  note: string;
  state: string;
  reason: string;
  position: number;
  behind: number;
  delivered: number;
  failing: string | null;
  attempts: number;
  error: string;
}

interface Delivery {
  number: number;
  at: string;
  event: string;
  seq: number | null;
  attempt: number;
  status: number | null;
  seconds: number;
  taken: boolean;
  error: string;
}

/** Asked so often, s. */
const EVERY = 3;
const tone = (state: string): string => (state === "active" ? "good" : state === "failed" ? "bad" : "wait");

export function Webhooks() {
  const why = refusal("GET /webhooks");
  const chosen = useSignal<number | null>(null);
  const again = useSignal(0);
  const { value } = useRead<{ items: Webhook[] }>(why ? null : "/webhooks", again.value, Math.floor(tick.value / EVERY));
  const webhook = value?.items.find(({ id }) => id === chosen.value);
  return (
    <section class="room" aria-label={t("webhooks")}>
      <div class="head">
        <h2>{t("webhooks")}</h2>
      </div>
      {why ? (
        <p class="nothing">{why}</p>
      ) : (
        <div class="split">
          <Table
            label={t("webhooks")}
            rows={value?.items}
            keyOf={(row) => String(row.id)}
            pick={(row) => (chosen.value = row.id)}
            chosen={String(chosen.value)}
            none={t("no_webhooks")}
            columns={[
              { name: "#", by: (row) => row.id, of: (row) => row.id, number: true },
              {
                name: "URL",
                by: (row) => row.url,
                of: (row) => (
                  <button type="button" class="text" onClick={() => (chosen.value = row.id)}>
                    {row.url}
                  </button>
                ),
              },
              { name: t("state"), by: (row) => row.state, of: (row) => <span class={tone(row.state)}>{said(`hook_${row.state}`)}</span> },
              { name: t("behind"), by: (row) => row.behind, of: (row) => row.behind, number: true },
              { name: t("delivered"), by: (row) => row.delivered, of: (row) => row.delivered, number: true },
              { name: t("failing_since"), by: (row) => row.failing, of: (row) => (row.failing ? moment(row.failing) : "") },
            ]}
          />
          <div>
            {webhook && <Detail key={webhook.id} webhook={webhook} after={() => again.value++} />}
            <Subscribe after={() => again.value++} />
          </div>
        </div>
      )}
    </section>
  );
}

function Detail({ webhook, after }: { webhook: Webhook; after: () => void }) {
  const path = `/webhooks/${webhook.id}`;
  const from = useSignal("");
  const secret = useSignal("");
  const asking = useAsking();
  const round = useSignal(0);
  const { value } = useRead<{ items: Delivery[] }>(`${path}/deliveries?limit=20`, round.value, webhook.delivered, webhook.attempts);
  const ask = async (what: () => Promise<unknown>, words?: string): Promise<void> => {
    await asking.ask(what, words);
    round.value++;
    after();
  };
  const ping = (): Promise<void> =>
    ask(async () => {
      const tried = await post<Delivery>(`${path}/ping`);
      if (!tried.taken) throw new Error(tried.error);
    }, t("pinged"));
  const renew = (): Promise<void> =>
    ask(async () => {
      secret.value = (await post<{ secret: string }>(`${path}/secret`, {})).secret;
    }, t("both_sign"));
  const active = webhook.state === "active";
  return (
    <section class="stack padded" data-webhook={webhook.id} aria-label={`#${webhook.id}`}>
      <h2 class="sub">
        #{webhook.id} {webhook.note}
      </h2>
      {(webhook.reason || webhook.error) && <p class="note held">{tell(webhook.reason || webhook.error)}</p>}
      <dl class="facts">
        <Fact name={t("events")}>{webhook.events.length ? webhook.events.map(happening).join(", ") : t("all")}</Fact>
        <Fact name={t("told_up_to")}>#{webhook.position}</Fact>
      </dl>
      <div class="acts-row">
        <Button needs="PATCH /webhooks/{webhook}" onClick={() => void ask(() => call("PATCH", path, { active: !active }))}>
          {t(active ? "pause" : "resume")}
        </Button>
        <Button needs="POST /webhooks/{webhook}/ping" disabled={asking.busy.value} onClick={() => void ping()}>
          {t("ping")}
        </Button>
        <Sure needs="POST /webhooks/{webhook}/secret" label={t("new_secret")} does={() => void renew()} />
        <Sure needs="DELETE /webhooks/{webhook}" label={t("remove")} does={() => void ask(() => call("DELETE", path))} />
      </div>
      <div class="fields">
        <Field label={t("replay_after")} name="after" type="number" min={0} value={from} />
        <div class="acts-row">
          <Sure
            needs="POST /webhooks/{webhook}/replay"
            label={t("replay")}
            disabled={from.value === ""}
            does={() => void ask(() => post(`${path}/replay`, { after: Number(from.value) }))}
          />
        </div>
      </div>
      <Told asking={asking} />
      <Once label={t("secret")} value={secret} />
      <table class="bits" aria-label={t("deliveries")}>
        <tbody>
          {value?.items.map((one) => (
            <tr key={one.number}>
              <th>{moment(one.at)}</th>
              <td class={one.taken ? "good" : "bad"}>{one.status ?? "–"}</td>
              <td>
                {happening(one.event)} {one.seq !== null && `#${one.seq}`} · {one.seconds.toFixed(2)} s {one.error && `· ${tell(one.error)}`}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

function Subscribe({ after }: { after: () => void }) {
  const [url, events, note, from] = [useSignal(""), useSignal(""), useSignal(""), useSignal("")];
  const secret = useSignal("");
  const asking = useAsking();
  const send = async (event: Event): Promise<void> => {
    event.preventDefault();
    const body = {
      url: url.value.trim(),
      events: events.value.split(/[\s,]+/).filter(Boolean),
      note: note.value.trim(),
      ...(from.value ? { after: Number(from.value) } : {}),
    };
    const done = await asking.ask(async () => {
      secret.value = (await post<{ secret: string }>("/webhooks", body)).secret;
    }, "");
    if (!done) return;
    url.value = events.value = note.value = from.value = "";
    after();
  };
  return (
    <form class="stack padded" aria-label={t("subscribe")} onSubmit={(event) => void send(event)}>
      <h2 class="sub">{t("subscribe")}</h2>
      <div class="fields">
        <Field label="URL" name="url" value={url} required wide />
        <Field label={t("events")} name="events" value={events} hint={t("all")} />
        <Field label={t("begin_after")} name="after" type="number" min={0} value={from} hint={t("from_now")} />
        <Field label={t("note")} name="note" value={note} wide />
      </div>
      <div class="acts-row">
        <Button needs="POST /webhooks" type="submit" disabled={asking.busy.value}>
          {t("subscribe")}
        </Button>
      </div>
      <Told asking={asking} />
      <Once label={t("secret")} value={secret} />
    </form>
  );
}
