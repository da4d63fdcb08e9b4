/** Audit walks along places after an outage: begun, entered at a place or from a file, compared, taken for true by a named person. */
import { useSignal } from "@preact/signals";
import { post } from "../api";
import { moment } from "../shows";
import { changes } from "../store";
import { said, t } from "../texts";
import type { Walk } from "../types";
import { Field, Told, useAsking, useRead } from "./asking";
import { Button } from "./Button";
import { Table } from "./Table";
import { WalkDetail } from "./WalkDetail";

export function Walks() {
  const chosen = useSignal<number | null>(null);
  const { value } = useRead<{ items: Walk[] }>("/walks/history?limit=200", changes.walks.value);
  const id = chosen.value ?? value?.items.find(({ state }) => state === "open")?.id ?? null;
  const walk = value?.items.find((one) => one.id === id);
  return (
    <section class="room" aria-label={t("walks")}>
      <div class="head">
        <h2>{t("walks")}</h2>
      </div>
      <div class="split walks">
        <div>
          <Begin begun={(number) => (chosen.value = number)} />
          <Table
            label={t("walks")}
            rows={value?.items}
            keyOf={(row) => String(row.id)}
            pick={(row) => (chosen.value = row.id)}
            chosen={String(id)}
            none={t("no_walks")}
            columns={[
              { name: "#", by: (row) => row.id, of: (row) => row.id, number: true },
              {
                name: t("reason"),
                by: (row) => row.reason,
                of: (row) => (
                  <button type="button" class="text" onClick={() => (chosen.value = row.id)}>
                    {row.reason}
                  </button>
                ),
              },
              { name: t("state"), by: (row) => row.state, of: (row) => <span class={row.state === "open" ? "wait" : ""}>{said(`walk_${row.state}`)}</span> },
              { name: t("entered"), by: (row) => row.entered, of: (row) => `${row.entered} / ${row.places}`, number: true },
              { name: t("begun"), by: (row) => row.started, of: (row) => `${moment(row.started)} · ${row.actor}` },
            ]}
          />
        </div>
        {walk ? <WalkDetail key={walk.id} walk={walk} /> : <p class="nothing">{t("choose_walk")}</p>}
      </div>
    </section>
  );
}

/** Along every side buffer, or along the stations that are named. */
function Begin({ begun }: { begun: (number: number) => void }) {
  const [reason, stations] = [useSignal(""), useSignal("")];
  const asking = useAsking();
  const send = async (event: Event): Promise<void> => {
    event.preventDefault();
    const names = stations.value.split(/[\s,]+/).filter(Boolean);
    const done = await asking.ask(async () => {
      const made = await post<Walk>("/walks", { reason: reason.value.trim(), stations: names });
      begun(made.id);
    });
    if (done) reason.value = stations.value = "";
  };
  return (
    <form class="stack padded" aria-label={t("begin_walk")} onSubmit={(event) => void send(event)}>
      <h2 class="sub">{t("begin_walk")}</h2>
      <div class="fields">
        <Field label={t("reason")} name="reason" value={reason} required />
        <Field label={t("stations")} name="stations" value={stations} hint={t("all_buffers")} />
      </div>
      <div class="acts-row">
        <Button needs="POST /walks" type="submit" disabled={asking.busy.value}>
          {t("begin_walk")}
        </Button>
      </div>
      <Told asking={asking} />
    </form>
  );
}
