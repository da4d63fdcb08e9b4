/** What is known of a drive's model, parameter by parameter; read once somebody opens it. */
import { useSignal } from "@preact/signals";
import { t, tell } from "../texts";
import { useRead } from "./asking";
import { Problem } from "./Problem";

interface Spec {
  number: string;
  name: string;
  unit: string;
  lowest: number | null;
  highest: number | null;
  default: number | null;
  read_only: boolean;
  while_running: boolean;
  description: string;
  choices: Record<string, string>;
}

export function DriveCatalogue({ path }: { path: string }) {
  const open = useSignal(false);
  const { value, error } = useRead<{ model: string; description: string; parameters: Spec[] }>(open.value ? `${path}/catalogue` : null);
  return (
    <details class="part acts" open={open.value} onToggle={(event) => (open.value = event.currentTarget.open)}>
      <summary>
        {t("catalogue")} {value?.model}
      </summary>
      <Problem error={error} />
      {value?.description && <p class="calm">{tell(value.description)}</p>}
      {value?.parameters.length === 0 && <p class="nothing">{t("no_catalogue")}</p>}
      {value && value.parameters.length > 0 && (
        <div class="scroll wide-table" tabIndex={0} role="group" aria-label={t("catalogue")}>
          <table class="list">
            <thead>
              <tr>
                {["#", t("name"), t("range"), t("default_value")].map((name) => (
                  <th key={name}>
                    <span>{name}</span>
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {value.parameters.map((spec) => (
                <tr key={spec.number} data-spec={spec.number}>
                  <td>{spec.number}</td>
                  <td>
                    {tell(spec.name)} <small class="calm basis">{wordsOf(spec)}</small>
                  </td>
                  <td>{rangeOf(spec)}</td>
                  <td>{spec.default ?? "–"}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </details>
  );
}

function rangeOf({ lowest, highest, unit }: Spec): string {
  return `${lowest ?? ""} … ${highest ?? ""} ${unit}`.trim();
}

function wordsOf(spec: Spec): string {
  const choices = Object.entries(spec.choices).map(([raw, word]) => `${raw}: ${tell(word)}`);
  return [tell(spec.description), choices.join(", "), spec.read_only ? t("read_only") : spec.while_running ? t("while_running") : ""].filter(Boolean).join(" · ");
}
