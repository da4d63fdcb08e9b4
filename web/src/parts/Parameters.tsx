/** A drive's parameters as last known, and how they are read from it. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { type Against, againstDrive } from "../against";
import { call, get, post } from "../api";
import { around, stopped } from "../around";
import { clock } from "../shows";
import { t, tell } from "../texts";
import type { Drive, Operation, Parameter } from "../types";
import { Button } from "./Button";
import { Problem } from "./Problem";
import { Sure } from "./Sure";

/** How an operation stands: done, under way, or why not. */
export function Outcome({ operation, label }: { operation: Operation | null; label: string }) {
  if (!operation) return null;
  if (operation.state === "failed" || operation.state === "unknown") {
    return (
      <div class="problem" role="alert">
        <b>{tell(operation.reason) || t("op_unknown")}</b>
        {operation.remedy && <span>{tell(operation.remedy)}</span>}
      </div>
    );
  }
  return (
    <span class={operation.state === "done" ? "done" : "wait"} role="status">
      {t(operation.state === "done" ? "op_done" : "op_running", label)}
    </span>
  );
}

export function Parameters({ drive }: { drive: Drive }) {
  const { id } = drive;
  const list = useSignal<Parameter[] | null>(null);
  const operation = useSignal<Operation | null>(null);
  const error = useSignal<unknown>(null);
  const here = useRef(true);
  const path = `/drives/${encodeURIComponent(id)}/parameters`;
  const refresh = async (): Promise<void> => {
    try {
      list.value = (await get<{ items: Parameter[] }>(path)).items;
    } catch {
      /* The list stays as it was; reading says what is wrong. */
    }
  };
  useEffect(() => {
    here.current = true;
    void refresh();
    return () => {
      here.current = false;
    };
  }, [id]);
  const named = list.value?.filter((parameter) => parameter.named).map((parameter) => parameter.number) ?? [];
  const read = async (): Promise<void> => {
    error.value = null;
    try {
      let now = await post<Operation>(`/drives/${encodeURIComponent(id)}/read`, named.length ? { parameters: named } : {});
      operation.value = now;
      while (now.state === "running" && here.current) {
        now = await get<Operation>(`/operations/${encodeURIComponent(now.id)}?wait=1`);
        operation.value = now;
        await refresh();
      }
    } catch (failure) {
      error.value = failure;
    }
  };
  const running = operation.value?.state === "running";
  const known = list.value?.filter((parameter) => parameter.named || parameter.raw !== null) ?? [];
  return (
    <section class="part">
      <h3>
        {t("parameters")}
        {operation.value && running && <small>{t("reading", operation.value.done, operation.value.total)}</small>}
        <Button needs="POST /drives/{drive}/read" disabled={running} onClick={() => void read()} {...stopped(againstDrive(drive, "read", around()))}>
          {t("read_parameters")}
        </Button>
      </h3>
      <Problem error={error.value} />
      {!running && <Outcome operation={operation.value} label={t("read_parameters")} />}
      {known.length === 0 && <p class="nothing">{t("no_parameters")}</p>}
      <table class="bits numbered">
        <tbody>
          {known.map((parameter) => (
            <tr key={parameter.number} title={tell(parameter.description)}>
              <th>{parameter.number}</th>
              <td>{parameter.raw === null ? "–" : tell(parameter.text)}</td>
              <td>
                {tell(parameter.name)} {parameter.at && <small>· {clock(parameter.at)}</small>}
                {parameter.named && !parameter.read_only && parameter.raw !== null && (
                  <Write path={`${path}/${parameter.number}`} parameter={parameter} after={refresh} against={againstDrive(drive, "change", around())} />
                )}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

/** A new value, in the catalogue's unit; written only if the drive still has what is shown, and read back. */
function Write({ path, parameter, after, against }: { path: string; parameter: Parameter; after: () => Promise<void>; against: Against }) {
  const value = useSignal(parameter.value === null ? "" : String(parameter.value));
  const operation = useSignal<Operation | null>(null);
  const error = useSignal<unknown>(null);
  const write = async (): Promise<void> => {
    error.value = operation.value = null;
    try {
      operation.value = await call<Operation>("PUT", `${path}?wait=10`, { value: Number(value.value) }, { "If-Match": `"${parameter.raw}"` });
      await after();
    } catch (failure) {
      error.value = failure;
    }
  };
  const range = parameter.lowest === null ? "" : `${parameter.lowest} … ${parameter.highest ?? ""} ${parameter.unit}`;
  return (
    <details class="write">
      <summary>{t("write")}</summary>
      <div class="acts-row">
        <input aria-label={`${parameter.number} ${tell(parameter.name)}`} title={range} placeholder={range} value={value.value} onInput={(event) => (value.value = event.currentTarget.value)} />
        <Sure needs="PUT /drives/{drive}/parameters/{number}" label={t("write")} disabled={value.value.trim() === "" || Number.isNaN(Number(value.value))} does={() => void write()} {...stopped(against)} />
        <small class="calm">{range}</small>
      </div>
      <Problem error={error.value} />
      <Outcome operation={operation.value} label={t("write")} />
    </details>
  );
}
