/** Taught values as files: saved, and read back after a look at what each row would come to. */
import { useSignal } from "@preact/signals";
import { download, upload } from "../api";
import { moment } from "../shows";
import { changes } from "../store";
import { t, tell } from "../texts";
import { Choice, Told, useAsking, useRead } from "./asking";
import { Name } from "./Name";
import { Sure } from "./Sure";
import { Table } from "./Table";

type Side = "dests" | "offsets";

interface Fate {
  line: number;
  name: string;
  fate: string;
  detail: string;
  remedy: string;
}

interface Report {
  dry_run: boolean;
  counts: Record<string, number>;
  items: Fate[];
}

const TONES: Record<string, string> = { new: "good", changed: "wait", same: "calm", error: "bad" };

export function TeachingFiles() {
  const side = useSignal<Side>("dests");
  const file = useSignal<File | null>(null);
  const report = useSignal<Report | null>(null);
  const asking = useAsking();
  const ask = (dry: boolean): void =>
    void asking.ask(
      async () => {
        const given = file.value as File;
        report.value = null;
        report.value = await upload<Report>(`/teaching/${side.value}/import?dry_run=${dry}`, await given.text(), given.name.endsWith(".json") ? "application/json" : "text/csv");
        if (!dry) file.value = null;
      },
      dry ? "" : t("imported"),
    );
  const choose = (chosen: File | undefined): void => {
    file.value = chosen ?? null;
    if (chosen) ask(true);
  };
  const save = (kind: "csv" | "json", history: boolean): void =>
    void asking.ask(() => download(`/teaching/${side.value}?format=${kind}&history=${history}`, `${side.value}.${kind}`), "");
  const found = report.value;
  const wrong = found?.counts["error"] ?? 0;
  return (
    <div class="filtered">
      <div class="stack padded">
        <div class="fields">
          <Choice
            label={t("kind")}
            value={side}
            of={[
              ["dests", t("dests_of_ports")],
              ["offsets", t("offsets_of_vehicles")],
            ]}
          />
          <div class="acts-row">
            <button type="button" onClick={() => save("csv", false)}>
              {t("save_csv")}
            </button>
            <button type="button" onClick={() => save("json", false)}>
              {t("save_json")}
            </button>
            <button type="button" onClick={() => save("csv", true)}>
              {t("save_history")}
            </button>
            <label class="file">
              <span>{t("read_file")}</span>
              <input
                type="file"
                accept=".csv,.json,text/csv,application/json"
                aria-label={t("read_file")}
                onChange={(event) => {
                  choose(event.currentTarget.files?.[0]);
                  event.currentTarget.value = "";
                }}
              />
            </label>
          </div>
        </div>
        {found && (
          <p role="status" data-import={found.dry_run ? "tried" : "done"}>
            {(["new", "changed", "same", "error"] as const).map((fate) => (
              <span key={fate} class={TONES[fate] ?? ""}>
                <b>{found.counts[fate]}</b> {t(`fate_${fate}`)}{" "}
              </span>
            ))}
          </p>
        )}
        {found?.dry_run && file.value && (
          <div class="acts-row">
            <span>{wrong ? t("import_wrong") : t("import_ready", file.value.name)}</span>
            <Sure
              needs={side.value === "dests" ? "POST /teaching/dests/import" : "POST /teaching/offsets/import"}
              label={t("import")}
              disabled={wrong > 0}
              does={() => ask(false)}
            />
          </div>
        )}
        <Told asking={asking} />
      </div>
      {!found && <InForce side={side.value} />}
      {found && <Table
        label={t("import")}
        rows={found.items}
        keyOf={(row) => String(row.line)}
        none={t("import_none")}
        columns={[
          { name: t("line_of_file"), by: (row) => row.line, of: (row) => row.line, number: true },
          { name: t("name"), by: (row) => row.name, of: (row) => <Name id={row.name} /> },
          { name: t("result"), by: (row) => row.fate, of: (row) => <b class={TONES[row.fate] ?? ""}>{t(`fate_${row.fate as "new"}`)}</b> },
          { name: t("in_words"), wraps: true, of: (row) => [tell(row.detail), tell(row.remedy)].filter(Boolean).join("; ") },
        ]}
      />}
    </div>
  );
}

interface Taught {
  station?: string;
  vehicle?: string;
  version: number;
  shft: number | null;
  rota: number | null;
  lift: number | null;
  source: string;
  actor: string;
  at: string;
}

/** What the file would have: the values that pick-ups and put-downs are reckoned from now. */
function InForce({ side }: { side: Side }) {
  const { value } = useRead<{ items: Taught[] }>(`/teaching/${side}`, changes.teaching.value);
  const nameOf = (row: Taught): string => row.station ?? row.vehicle ?? "";
  return (
    <Table
      label={t("in_force")}
      rows={value?.items}
      keyOf={nameOf}
      none={t("never_taught")}
      columns={[
        { name: t("name"), by: nameOf, of: (row) => <Name id={nameOf(row)} /> },
        ...(["shft", "rota", "lift"] as const).map((axis) => ({ name: axis.toUpperCase(), by: (row: Taught) => row[axis], of: (row: Taught) => row[axis] ?? "–", number: true })),
        { name: t("version"), by: (row) => row.version, of: (row) => `v${row.version}`, number: true },
        { name: t("when"), by: (row) => row.at, of: (row) => moment(row.at) },
        { name: t("who"), by: (row) => row.actor, of: (row) => `${row.actor} · ${tell(row.source)}` },
      ]}
    />
  );
}
