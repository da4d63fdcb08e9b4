/** One audit walk: what was expected at each place, what was seen, what that comes to; and its end. */
import { useSignal } from "@preact/signals";
import { refusal } from "../access";
import { call, post } from "../api";
import { csvOf, rowsOf, save } from "../csv";
import { changes } from "../store";
import { said, t } from "../texts";
import type { Walk, WalkPlace } from "../types";
import { type Asking, Told, useAsking, useRead } from "./asking";
import { Button } from "./Button";
import { Name } from "./Name";
import { Reasoned } from "./Reasoned";
import { Table } from "./Table";

const FINDINGS = ["not_seen", "differs", "moved", "agrees"] as const;
const TONES: Record<string, string> = { agrees: "good", differs: "bad", moved: "wait", not_seen: "calm" };
const FULL = new Set(["full", "1", "yes", "true", "y", "있음"]);
const EMPTY = new Set(["empty", "0", "no", "false", "n", "없음"]);
/** So many sights the server takes at once. */
const AT_ONCE = 1000;

interface Sight {
  station: string;
  present: boolean;
  carrier: string | null;
}

/** What a file says was seen; lines without a word for it were not walked along. Raises Error: a line says something else. */
function sightsOf(text: string): Sight[] {
  const rows = rowsOf(text);
  if (!rows.some((row) => "station" in row && "seen" in row)) throw new Error(t("walk_file_columns"));
  return rows.flatMap((row, i) => {
    const word = (row["seen"] ?? "").toLowerCase();
    if (!word || !row["station"]) return [];
    if (!FULL.has(word) && !EMPTY.has(word)) throw new Error(t("walk_file_word", i + 2, row["seen"] ?? ""));
    return [{ station: row["station"], present: FULL.has(word), carrier: row["seen_carrier"] || null }];
  });
}

export function WalkDetail({ walk }: { walk: Walk }) {
  const only = useSignal<string>("");
  const asking = useAsking();
  const { value } = useRead<{ items: WalkPlace[] }>(`/walks/${walk.id}/places`, changes.walks.value, changes.stations.value);
  const places = value?.items ?? [];
  const open = walk.state === "open";
  const counts = Object.fromEntries(FINDINGS.map((name) => [name, places.filter(({ finding }) => finding === name).length]));
  return (
    <div class="walk" data-walk={walk.id}>
      <div class="padded stack">
        <h2 class="sub">
          #{walk.id} {walk.reason} · {said(`walk_${walk.state}`)}
        </h2>
        <div class="acts-row" role="group" aria-label={t("finding")}>
          {FINDINGS.map((name) => (
            <button type="button" key={name} aria-pressed={only.value === name} onClick={() => (only.value = only.value === name ? "" : name)}>
              {t(`found_${name}`)} {counts[name]}
            </button>
          ))}
          <Files walk={walk} places={places} asking={asking} />
        </div>
        <Told asking={asking} />
      </div>
      <Table
        label={t("places")}
        rows={places.filter(({ finding }) => !only.value || finding === only.value)}
        keyOf={(row) => row.station}
        none={t("nothing_found")}
        columns={[
          { name: t("at_station"), by: (row) => row.station, of: (row) => <Name id={row.station} /> },
          { name: t("expected"), by: (row) => stands(row.now, row.now_carrier), of: (row) => stands(row.now, row.now_carrier) },
          { name: t("found"), by: (row) => stands(row.seen, row.seen_carrier), of: (row) => (row.seen === null ? "" : stands(row.seen, row.seen_carrier)) },
          { name: t("finding"), by: (row) => row.finding, of: (row) => <b class={TONES[row.finding] ?? ""}>{said(`found_${row.finding}`)}</b> },
          ...(open ? [{ name: t("enter"), of: (row: WalkPlace) => <Enter walk={walk.id} place={row} asking={asking} /> }] : [{ name: t("who"), of: (row: WalkPlace) => row.by ?? "" }]),
        ]}
      />
      {open && <Ends walk={walk} doubtful={(counts["not_seen"] ?? 0) + (counts["moved"] ?? 0)} />}
    </div>
  );
}

/** What stands at a place, in words. */
function stands(present: boolean | null, carrier: string | null): string {
  if (present === null) return t("unknown");
  return present ? (carrier ?? t("unread")) : t("empty");
}

function Enter({ walk, place, asking }: { walk: number; place: WalkPlace; asking: Asking }) {
  const before = place.seen_carrier ?? place.now_carrier;
  const carrier = useSignal(before ?? "");
  const enter = (present: boolean): void => {
    const written = carrier.value.trim() || null;
    // What stood there before is no word of this person's; what somebody wrote beside "empty" is refused, not dropped.
    const body = { present, carrier: present || written !== before ? written : null };
    void asking.ask(() => call("PUT", `/walks/${walk}/places/${encodeURIComponent(place.station)}`, body), t("entered_place", place.station));
  };
  return (
    <div class="acts-row enter">
      <Button needs="PUT /walks/{walk}/places/{station}" aria-pressed={place.seen === false} onClick={() => enter(false)}>
        {t("empty")}
      </Button>
      <Button needs="PUT /walks/{walk}/places/{station}" aria-pressed={place.seen === true} onClick={() => enter(true)}>
        {t("full")}
      </Button>
      <input
        aria-label={`${t("carrier")} ${place.station}`}
        placeholder={t("unread")}
        value={carrier.value}
        onInput={(event) => (carrier.value = event.currentTarget.value)}
        onKeyDown={(event) => event.key === "Enter" && enter(true)}
      />
    </div>
  );
}

/** The list to take along, and what came back in it. */
function Files({ walk, places, asking }: { walk: Walk; places: WalkPlace[]; asking: Asking }) {
  const write = (): void => {
    const word = (present: boolean | null): string => (present === null ? "" : present ? "full" : "empty");
    const rows = places.map((place) => ({ ...place, expected: word(place.now), expected_carrier: place.now_carrier, seen: word(place.seen) }));
    save(csvOf(["station", "expected", "expected_carrier", "seen", "seen_carrier", "finding", "by", "at"], rows), `walk-${walk.id}.csv`);
  };
  const read = async (file: File | undefined): Promise<void> => {
    if (!file) return;
    let taken = 0;
    await asking.ask(async () => {
      const sights = sightsOf(await file.text());
      if (sights.length === 0) throw new Error(t("walk_file_nothing"));
      for (let i = 0; i < sights.length; i += AT_ONCE) await post(`/walks/${walk.id}/places`, { sights: sights.slice(i, i + AT_ONCE) });
      taken = sights.length;
    }, "");
    if (taken) asking.done.value = t("walk_file_read", taken);
  };
  return (
    <>
      <button type="button" onClick={write}>
        {t("save_csv")}
      </button>
      {walk.state === "open" && refusal("POST /walks/{walk}/places") === "" && (
        <label class="file">
          <span>{t("read_csv")}</span>
          <input
            type="file"
            accept=".csv,text/csv"
            aria-label={t("read_csv")}
            onChange={(event) => {
              void read(event.currentTarget.files?.[0]);
              event.currentTarget.value = "";
            }}
          />
        </label>
      )}
    </>
  );
}

function Ends({ walk, doubtful }: { walk: Walk; doubtful: number }) {
  const path = `/walks/${walk.id}`;
  return (
    <div class="padded">
      {doubtful > 0 && <p class="calm">{t("walk_doubtful", doubtful)}</p>}
      <Reasoned
        decisions={[
          {
            label: t(doubtful > 0 ? "accept_partial" : "accept"),
            needs: "POST /walks/{walk}/accept",
            bare: true,
            grave: true,
            does: () => post(`${path}/accept`, { partial: doubtful > 0 }),
          },
          { label: t("abandon"), needs: "POST /walks/{walk}/abandon", grave: true, does: (reason) => post(`${path}/abandon`, { reason }) },
        ]}
      />
    </div>
  );
}
