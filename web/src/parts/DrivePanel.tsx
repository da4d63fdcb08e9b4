/** One axis drive: what it says of itself, and what is wrong. */
import { useSignal } from "@preact/signals";
import { againstDrive } from "../against";
import { post, serverNow } from "../api";
import { around, stopped } from "../around";
import { hundredths, lookOfDrive, span } from "../shows";
import { driveNow, tick } from "../store";
import { said, t, tell } from "../texts";
import type { Drive, Operation } from "../types";
import { Missing } from "./Away";
import { Button } from "./Button";
import { DriveTools } from "./DriveTools";
import { Fact, Panel } from "./Panel";
import { Outcome, Parameters } from "./Parameters";
import { Problem } from "./Problem";

export const COLOURS = { calm: "var(--dim)", go: "var(--accent)", wait: "var(--wait)", good: "var(--good)", bad: "var(--bad)" };

export function DrivePanel({ id }: { id: string }) {
  const now = driveNow(id);
  void tick.value;
  if (!now) return <Missing id={id} />;
  const { word, tone } = lookOfDrive(now);
  return (
    <Panel title={now.id} tag={tell(now.name)} colour={COLOURS[tone]}>
      <Notes drive={now} />
      <dl>
        <Fact name={t("state")}>
          <b class={tone}>{t(`drive_${word}`)}</b>
        </Fact>
        {now.mode !== null && (
          <Fact name={t(now.mode === "error" ? "error_fact" : "operation_fact")}>
            {said(tell(now.meaning)) || "–"} <small>{now.code}</small>
          </Fact>
        )}
        {now.online && (
          <Fact name={t("moves")}>{now.moving === null ? t("unknown") : t(now.moving ? "yes" : "no")}</Fact>
        )}
        {now.output !== null && <Fact name={t("output")}>{now.output}</Fact>}
        {now.distance !== null && (
          <Fact name={t("distance")}>
            {hundredths(now.distance)} {now.turn && <small>· {said(now.turn)}</small>}
          </Fact>
        )}
        <Fact name={t("model")}>{now.model || t("no_model")}</Fact>
        <Fact name={t("on_line")}>{t("line_number", now.line, now.address)}</Fact>
        {!now.online && (
          <Fact name={t("seen")}>{now.seen ? t("ago", span(serverNow() - Date.parse(now.seen))) : "–"}</Fact>
        )}
      </dl>
      <StopKey drive={now} />
      <DriveTools drive={now} />
      <Parameters drive={now} />
    </Panel>
  );
}

/** Stops the axis, or resets an error: at once, since a stop asks nobody whether he is sure. */
function StopKey({ drive }: { drive: Drive }) {
  const error = useSignal<unknown>(null);
  const done = useSignal<Operation | null>(null);
  const press = (): void => {
    error.value = done.value = null;
    post<Operation>(`/drives/${encodeURIComponent(drive.id)}/keys?wait=5`, { key: "stop_reset" }).then(
      (operation) => (done.value = operation),
      (failure: unknown) => (error.value = failure),
    );
  };
  return (
    <>
      <div class="buttons">
        <Button needs="POST /drives/{drive}/keys" class="halt" onClick={press} {...stopped(againstDrive(drive, "harmless", around()))}>
          {t("stop_reset")}
        </Button>
      </div>
      <Problem error={error.value} />
      <Outcome operation={done.value} label={t("stop_reset")} />
    </>
  );
}

/** What is wrong with it, why it is not heard, who has locked it out. */
export function Notes({ drive }: { drive: Drive }) {
  return (
    <>
      {drive.mode === "error" && drive.online && (
        <p class="note alarm">
          <b>{tell(drive.error || drive.meaning)}</b> {drive.remedy && <em>{tell(drive.remedy)}</em>}
        </p>
      )}
      {!drive.online && drive.reason && (
        <p class="note held">
          <b>{t(drive.online === null ? "drive_not_heard" : "drive_offline")}</b> {tell(drive.reason)}
        </p>
      )}
      {drive.lockout && (
        <p class="note held">
          <b>{t("locked", drive.lockout.owner)}</b> {drive.lockout.reason}
        </p>
      )}
    </>
  );
}
