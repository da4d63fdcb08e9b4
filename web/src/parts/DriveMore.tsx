/** A drive's status asked for now, its inputs, what was asked of it lately, and the packets on its line. */
import { useSignal } from "@preact/signals";
import { againstDrive } from "../against";
import { call, post } from "../api";
import { around, stopped } from "../around";
import { moment } from "../shows";
import { changes } from "../store";
import { said, t, tell } from "../texts";
import type { Drive, Operation } from "../types";
import { Told, useAsking, useRead } from "./asking";
import { Button } from "./Button";
import { LineFrames } from "./Frames";
import { Outcome } from "./Parameters";
import { Sure } from "./Sure";

export function DriveMore({ drive, path }: { drive: Drive; path: string }) {
  return (
    <>
      <Inputs path={path} drive={drive} />
      <Operations path={path} drive={drive} />
      <LineFrames path={`${path}/frames`} />
    </>
  );
}

const INPUTS = ["run", "home"] as const;

/** What is not named is off: one press sets one of them, or none. */
function Inputs({ path, drive }: { path: string; drive: Drive }) {
  const asking = useAsking();
  const operation = useSignal<Operation | null>(null);
  const label = useSignal("");
  const ask = (words: string, what: () => Promise<Operation>): void => {
    label.value = words;
    operation.value = null;
    void asking.ask(async () => {
      operation.value = await what();
    }, "");
  };
  return (
    <details class="part acts">
      <summary>{t("inputs")}</summary>
      <div class="stack">
        <div class="acts-row">
          <Button needs="POST /drives/{drive}/status" onClick={() => ask(t("ask_status"), () => post(`${path}/status?wait=5`))} {...stopped(againstDrive(drive, "harmless", around()))}>
            {t("ask_status")}
          </Button>
          {INPUTS.map((name) => (
            <Sure
              key={name}
              needs="PUT /drives/{drive}/inputs"
              label={t(`input_${name}`)}
              does={() => ask(t(`input_${name}`), () => call("PUT", `${path}/inputs?wait=5`, { [name]: true }))}
              {...stopped(againstDrive(drive, "move", around()))}
            />
          ))}
          <Button needs="PUT /drives/{drive}/inputs" onClick={() => ask(t("inputs_off"), () => call("PUT", `${path}/inputs?wait=5`, {}))} {...stopped(againstDrive(drive, "change", around()))}>
            {t("inputs_off")}
          </Button>
        </div>
        <Told asking={asking} />
        <Outcome operation={operation.value} label={label.value} />
      </div>
    </details>
  );
}

interface Past extends Operation {
  actor: string;
  opened: string;
}

/** Each ended done, failed, or unknown; what still runs can be cancelled. */
function Operations({ path, drive }: { path: string; drive: Drive }) {
  const open = useSignal(false);
  const again = useSignal(0);
  const asking = useAsking();
  const { value } = useRead<{ items: Past[] }>(open.value ? `${path}/operations?limit=20` : null, drive.operation, again.value, Math.floor(changes.drives.value / 20));
  const cancel = async (id: string): Promise<void> => {
    await asking.ask(() => post(`/operations/${encodeURIComponent(id)}/cancel`));
    again.value++;
  };
  return (
    <details class="part acts" open={open.value} onToggle={(event) => (open.value = event.currentTarget.open)}>
      <summary>{t("operations")}</summary>
      <Told asking={asking} />
      {value?.items.length === 0 && <p class="nothing">{t("no_operations")}</p>}
      <table class="bits">
        <tbody>
          {value?.items.map((one) => (
            <tr key={one.id} data-operation={one.id}>
              <th>#{one.id}</th>
              <td class={one.state === "done" ? "good" : one.state === "running" ? "wait" : "bad"}>{said(`op_state_${one.state}`)}</td>
              <td>
                {said(one.kind)} · {one.actor} · {moment(one.opened)} {one.reason && ` · ${tell(one.reason)}`}
                {one.state === "running" && <Sure needs="POST /operations/{operation}/cancel" label={t("cancel")} does={() => void cancel(one.id)} />}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </details>
  );
}
