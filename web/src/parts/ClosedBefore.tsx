/** What was closed before: by whom, why, how long, and who opened it. */
import { useSignal } from "@preact/signals";
import { placed } from "../closed";
import { moment } from "../shows";
import { changes } from "../store";
import { said, t } from "../texts";
import type { Closure } from "../types";
import { useRead } from "./asking";

type Past = Closure & { ended: string | null; ended_by: string | null };

export function ClosedBefore() {
  const open = useSignal(false);
  const { value } = useRead<{ items: Past[] }>(open.value ? "/closures/history?limit=50" : null, changes.closures.value);
  const past = value?.items.filter(({ ended }) => ended !== null) ?? [];
  return (
    <details class="padded" open={open.value} onToggle={(event) => (open.value = event.currentTarget.open)}>
      <summary>{t("closed_before")}</summary>
      {open.value && value && past.length === 0 && <p class="nothing">{t("nothing_found")}</p>}
      <ul>
        {past.map((closure) => (
          <li key={closure.id}>
            <b>{placed(closure.place)}</b> · {closure.reason} · {closure.owner} · {moment(closure.since)} – {moment(closure.ended ?? "")}{" "}
            <span class="calm">
              {said(closure.state)} {closure.ended_by}
            </span>
          </li>
        ))}
      </ul>
    </details>
  );
}
