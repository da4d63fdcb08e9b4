/** How vehicles held out: failures, mean time between them and to repair; each leads to what failed. */
import { useSignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { serverNow } from "../api";
import { changes } from "../store";
import { t } from "../texts";
import { useRead } from "./asking";
import { Name } from "./Name";
import { Problem } from "./Problem";
import { Table } from "./Table";

interface Row {
  vehicle: string;
  failures: number;
  down_minutes: number;
  mtbf_hours: number | null;
  mttr_minutes: number | null;
  availability: number;
}

const PERIODS = { shift: 8 * 3600, day: 86_400, week: 7 * 86_400 } as const;
type Period = keyof typeof PERIODS;

export function Reliability({ show }: { show: (vehicle: string) => void }) {
  const period = useSignal<Period>("week");
  const round = changes.alarms.value;
  const query = useMemo(() => {
    const now = serverNow();
    return new URLSearchParams({ from: new Date(now - PERIODS[period.value] * 1000).toISOString(), to: new Date(now).toISOString() });
  }, [period.value, round]);
  const { value, error } = useRead<{ items: Row[] }>(`/alarms/reliability?${query}`);
  return (
    <div class="filtered">
      <div class="filters">
        <span class="tabs">
          {(Object.keys(PERIODS) as Period[]).map((name) => (
            <button type="button" key={name} aria-pressed={period.value === name} onClick={() => (period.value = name)}>
              {t(`period_${name}`)}
            </button>
          ))}
        </span>
        <Problem error={error} />
      </div>
      <Table
        label={t("reliability")}
        rows={value?.items}
        keyOf={(row) => row.vehicle}
        none={t("nothing_found")}
        columns={[
          { name: t("vehicle"), by: (row) => row.vehicle, of: (row) => <Name id={row.vehicle} /> },
          { name: t("failures"), by: (row) => row.failures, of: (row) => row.failures, number: true },
          { name: t("down_minutes"), by: (row) => row.down_minutes, of: (row) => row.down_minutes.toFixed(1), number: true },
          { name: t("mtbf_hours"), by: (row) => row.mtbf_hours, of: (row) => row.mtbf_hours?.toFixed(2) ?? "–", number: true },
          { name: t("mttr_minutes"), by: (row) => row.mttr_minutes, of: (row) => row.mttr_minutes?.toFixed(1) ?? "–", number: true },
          { name: t("availability"), by: (row) => row.availability, of: (row) => `${(row.availability * 100).toFixed(2)} %`, number: true },
          {
            name: t("failures_of"),
            of: (row) => (
              <button type="button" class="text" disabled={row.failures === 0} onClick={() => show(row.vehicle)}>
                {t("alarms_history")}
              </button>
            ),
          },
        ]}
      />
    </div>
  );
}
