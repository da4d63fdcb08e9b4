/** Lines that carry several devices: connected or not, since when and why not, how they do; and the one stop for all drives on one. */
import { useSignal } from "@preact/signals";
import { post } from "../api";
import { none } from "../known";
import { clock } from "../shows";
import { tick } from "../store";
import { said, t, tell } from "../texts";
import { Told, useAsking, useRead } from "./asking";
import { Button } from "./Button";
import { Frames } from "./Frames";
import { Name } from "./Name";

interface Line {
  id: string;
  wire: string;
  address: string;
  up: boolean;
  since: string | null;
  reason: string;
  devices: string[];
  figures: Record<string, number>;
}

/** Asked so often, s. */
const EVERY = 3;

export function LineList() {
  const { value } = useRead<{ items: Line[] }>("/links", Math.floor(tick.value / EVERY));
  return (
    <ul class="scroll alarms lines" tabIndex={0} aria-label={t("lines")}>
      {!value?.items.length && <li class="nothing">{none(t(value ? "no_lines" : "loading"))}</li>}
      {value?.items.map((line) => (
        <Row key={line.id} line={line} />
      ))}
    </ul>
  );
}

/** A count by its word, if it has one. */
function countName(name: string): string {
  const word = said(`count_${name}`);
  return word === `count ${name.replaceAll("_", " ")}` ? name.replaceAll("_", " ") : word;
}

function Row({ line }: { line: Line }) {
  const open = useSignal(false);
  const asking = useAsking();
  const path = `/links/${encodeURIComponent(line.id)}`;
  const figures = Object.entries(line.figures).map(([name, count]) => `${countName(name)} ${count}`);
  return (
    <li data-line={line.id}>
      <span class={`sign ${line.up ? "good" : ""}`}>{line.up ? "●" : "✕"}</span>
      <span>
        <b>{line.id}</b> · {line.wire.toUpperCase()} · {line.address} ·{" "}
        <span class={line.up ? "good" : "bad"}>{t(line.up ? "link_up" : "link_down", line.since ? clock(line.since) : "–")}</span>
        {!line.up && line.reason && ` · ${tell(line.reason)}`} ·{" "}
        {line.devices.map((id) => (
          <span key={id}>
            <Name id={id} />{" "}
          </span>
        ))}
      </span>
      <p class="remedy">{figures.join(" · ")}</p>
      <div class="wide acts-row">
        {line.wire === "hi" && (
          <Button needs="POST /links/{link}/stop" class="halt" onClick={() => void asking.ask(() => post(`${path}/stop?wait=5`), t("line_stopped"))}>
            {t("stop_line")}
          </Button>
        )}
        <button type="button" aria-expanded={open.value} onClick={() => (open.value = !open.value)}>
          {t("last_frames")}
        </button>
        <Told asking={asking} />
      </div>
      {open.value && (
        <div class="wide">
          <Frames path={`${path}/frames`} />
        </div>
      )}
    </li>
  );
}
