/** Stations and carriers: where everything is believed to be, and how well that is known. */
import { useSignal } from "@preact/signals";
import { call, serverNow } from "../api";
import { counted } from "../known";
import { span } from "../shows";
import { carrierList, selected, stationList, tick } from "../store";
import { said, t } from "../texts";
import { Field, Told, useAsking } from "./asking";
import { Button } from "./Button";
import { Name } from "./Name";
import { Sure } from "./Sure";
import { Table } from "./Table";

export function Stations() {
  const tab = useSignal<"stations" | "carriers">("stations");
  const letters = useSignal("");
  const group = useSignal("all");
  void tick.value;
  const wanted = letters.value.trim().toLowerCase();
  const hits = (...names: (string | null)[]): boolean => names.some((name) => name?.toLowerCase().includes(wanted));
  const groups: Record<string, (station: (typeof stationList.value)[number]) => boolean> = {
    all: () => true,
    present: (station) => station.present === true,
    free: (station) => station.present === false,
    unknown: (station) => station.present === null,
    believed: (station) => !station.verified,
    out_of_service: (station) => station.out_of_service !== "",
    reserved: (station) => station.reserved !== "",
  };
  const stations = stationList.value.filter((station) => hits(station.id, station.carrier, station.barcode) && groups[group.value]?.(station));
  const carriers = carrierList.value.filter((carrier) => hits(carrier.id, carrier.place));
  const since = (at: string | null): string => (at ? t("ago", span(serverNow() - Date.parse(at))) : "");
  return (
    <section class="room" aria-label={t("stations")}>
      <div class="head">
        <h2 class="tabs-head">
          <span class="tabs">
            <button type="button" aria-pressed={tab.value === "stations"} onClick={() => (tab.value = "stations")}>
              {t("stations")} {counted(stationList.value.length)}
            </button>
            <button type="button" aria-pressed={tab.value === "carriers"} onClick={() => (tab.value = "carriers")}>
              {t("carriers")} {counted(carrierList.value.length)}
            </button>
          </span>
        </h2>
        {tab.value === "stations" && (
          <select aria-label={t("state")} value={group.value} onChange={(event) => (group.value = event.currentTarget.value)}>
            {Object.keys(groups).map((name) => (
              <option key={name} value={name}>
                {name === "free" ? t("empty") : said(name)}
              </option>
            ))}
          </select>
        )}
        <input type="search" aria-label={t("filter")} placeholder={t("filter")} value={letters.value} onInput={(event) => (letters.value = event.currentTarget.value)} />
      </div>
      {tab.value === "stations" ? (
        <Table
          label={t("stations")}
          rows={stations}
          keyOf={({ id }) => id}
          pick={({ id }) => (selected.value = { kind: "station", id })}
          chosen={selected.value?.kind === "station" ? selected.value.id : null}
          none={t("nothing_found")}
          columns={[
            { name: t("at_station"), by: ({ id }) => id, of: ({ id }) => <Name id={id} /> },
            { name: t("kind"), by: ({ kind }) => kind, of: ({ kind }) => said(kind) },
            { name: t("barcode"), by: ({ barcode }) => barcode, of: ({ barcode }) => barcode },
            {
              name: t("present"),
              by: ({ present }) => (present === null ? null : Number(present)),
              of: ({ present }) => (present === null ? t("unknown") : t(present ? "yes" : "no")),
            },
            { name: t("carrier"), by: ({ carrier }) => carrier, of: ({ carrier }) => carrier ?? "" },
            { name: t("provenance"), by: ({ provenance }) => provenance, of: ({ provenance, verified }) => `${said(provenance)} · ${t(verified ? "verified" : "believed")}` },
            { name: t("age"), by: ({ at }) => at, of: ({ at }) => since(at) },
            { name: t("reserved"), by: ({ reserved }) => reserved || null, of: ({ reserved }) => reserved },
            { name: t("out_of_service"), by: (station) => station.out_of_service || null, of: (station) => station.out_of_service },
          ]}
        />
      ) : (
        <div class="split">
          <Table
            label={t("carriers")}
            rows={carriers}
            keyOf={({ id }) => id}
            none={t("nothing_found")}
            columns={[
              { name: t("carrier"), by: ({ id }) => id, of: ({ id }) => id },
              { name: t("place"), by: ({ place }) => place, of: ({ place }) => (place ? <Name id={place} /> : t("unknown")) },
              { name: t("provenance"), by: ({ provenance }) => provenance, of: ({ provenance, verified }) => `${said(provenance)} · ${t(verified ? "verified" : "believed")}` },
              { name: t("age"), by: ({ at }) => at, of: ({ at }) => since(at) },
              { name: "", of: ({ id }) => <Remove id={id} /> },
            ]}
          />
          <Install />
        </div>
      )}
    </section>
  );
}

function Remove({ id }: { id: string }) {
  const asking = useAsking();
  return (
    <>
      <Sure needs="DELETE /carriers/{carrier}" label={t("remove")} does={() => void asking.ask(() => call("DELETE", `/carriers/${encodeURIComponent(id)}`), "")} />
      <Told asking={asking} />
    </>
  );
}

/** A person says where a carrier is. */
function Install() {
  const carrier = useSignal("");
  const place = useSignal("");
  const asking = useAsking();
  const send = (event: Event): void => {
    event.preventDefault();
    const path = `/carriers/${encodeURIComponent(carrier.value.trim())}`;
    void asking.ask(() => call("PUT", path, { place: place.value.trim(), by_person: true }));
  };
  return (
    <form class="stack padded" onSubmit={send}>
      <h2 class="sub">{t("carrier_is")}</h2>
      <div class="fields">
        <Field label={t("carrier")} name="carrier" value={carrier} required />
        <Field label={t("place")} name="place" value={place} required />
      </div>
      <div class="acts-row">
        <Button needs="PUT /carriers/{carrier}" type="submit">
          {t("write_down")}
        </Button>
      </div>
      <Told asking={asking} />
    </form>
  );
}
