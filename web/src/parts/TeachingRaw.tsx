/** What vehicles sent while they were taught, as they sent it; and the offsets of two vehicles side by side. */
import { useSignal } from "@preact/signals";
import { moment } from "../shows";
import { changes, layout } from "../store";
import { t } from "../texts";
import type { Axes } from "../types";
import { Field, useRead } from "./asking";
import { Name } from "./Name";
import { Fact } from "./Panel";
import { Problem } from "./Problem";
import { Pulses } from "./Pulses";
import { Table } from "./Table";

interface Sent {
  number: number;
  at: string;
  vehicle: string;
  barcode: string;
  /** In hexadecimal. */
  code: string;
  axis: string | null;
  position: number | null;
  asked_by: string | null;
}

export function TeachingRaw() {
  const after = useSignal(0);
  const { value } = useRead<{ items: Sent[]; next: number | null }>(`/teaching/events?limit=200&after=${after.value}`, changes.teaching.value);
  return (
    <div class="filtered">
      <TwoOffsets />
      <Table
        label={t("teaching_events")}
        rows={[...(value?.items ?? [])].reverse()}
        keyOf={(row) => String(row.number)}
        none={t("no_proposals")}
        columns={[
          { name: "#", by: (row) => row.number, of: (row) => row.number, number: true },
          { name: t("when"), by: (row) => row.at, of: (row) => moment(row.at) },
          { name: t("vehicle"), by: (row) => row.vehicle, of: (row) => <Name id={row.vehicle} /> },
          { name: t("barcode"), by: (row) => row.barcode, of: (row) => row.barcode },
          { name: t("what"), by: (row) => row.code, of: (row) => `${row.axis?.toUpperCase() ?? "–"} · 0x${row.code}` },
          { name: t("position"), by: (row) => row.position, of: (row) => row.position ?? "–", number: true },
          { name: t("asked_by"), by: (row) => row.asked_by, of: (row) => row.asked_by ?? "" },
        ]}
      />
      <div class="padded acts-row">
        <button type="button" disabled={after.value === 0} onClick={() => (after.value = 0)}>
          {t("from_start")}
        </button>
        <button type="button" disabled={!value?.next} onClick={() => (after.value = value?.next ?? 0)}>
          {t("newer_rows")} ▶
        </button>
      </div>
    </div>
  );
}

interface Compared {
  one: Axes | null;
  other: Axes | null;
  differences: Axes | null;
}

function TwoOffsets() {
  const [one, other] = [useSignal(""), useSignal("")];
  const hoists = layout.value?.vehicles.filter(({ kind }) => kind !== "agv") ?? [];
  const known = (id: string): boolean => hoists.some((vehicle) => vehicle.id === id);
  const ready = known(one.value) && known(other.value) && one.value !== other.value;
  const path = `/teaching/compare/offsets/${encodeURIComponent(one.value)}/${encodeURIComponent(other.value)}`;
  const { value, error } = useRead<Compared>(ready ? path : null, changes.teaching.value);
  return (
    <div class="stack padded" role="group" aria-label={t("compare_offsets")}>
      <h2 class="sub">{t("compare_offsets")}</h2>
      <div class="fields">
        <Field label={t("vehicle")} name="one" value={one} list="offset-hoists" />
        <Field label={t("vehicle_other")} name="other" value={other} list="offset-hoists" />
      </div>
      <datalist id="offset-hoists">{hoists.map(({ id }) => <option key={id} value={id} />)}</datalist>
      {ready && <Problem error={error} />}
      {ready && value && (
        <dl class="facts">
          <Fact name={one.value}>
            <Pulses axes={value.one} />
          </Fact>
          <Fact name={other.value}>
            <Pulses axes={value.other} />
          </Fact>
          <Fact name={t("difference")}>
            <Pulses axes={value.differences} signed />
          </Fact>
        </dl>
      )}
    </div>
  );
}
