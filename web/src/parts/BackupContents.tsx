/** What a backup of a drive has: each parameter raw, and in its unit where the model's catalogue names it. */
import { useSignal } from "@preact/signals";
import { t, tell } from "../texts";
import { useRead } from "./asking";
import { Problem } from "./Problem";

interface Kept {
  parameter: string;
  raw: number;
  name: string;
  value: number | null;
  unit: string;
}

export function BackupContents({ path }: { path: string }) {
  const open = useSignal(false);
  const { value, error } = useRead<{ values: Kept[] }>(open.value ? path : null);
  return (
    <details class="contents" open={open.value} onToggle={(event) => (open.value = event.currentTarget.open)}>
      <summary>{t("backup_contents")}</summary>
      <Problem error={error} />
      {value && (
        <table class="bits">
          <tbody>
            {value.values.map((row) => (
              <tr key={row.parameter}>
                <th>{row.parameter}</th>
                <td>{row.raw}</td>
                <td>
                  {tell(row.name)} {row.value !== null && `${row.value} ${row.unit}`}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </details>
  );
}
