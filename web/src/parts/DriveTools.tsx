/** What can be done to a drive: jog, write a parameter, back up, compare, restore; each an operation that ends in one known way. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { againstDrive } from "../against";
import { call, get, post } from "../api";
import { around, stopped } from "../around";
import { clock } from "../shows";
import { driveList } from "../store";
import { t } from "../texts";
import type { Backup, Drive, Operation } from "../types";
import { Field, Told, useAsking, useRead } from "./asking";
import { Button } from "./Button";
import { BackupContents } from "./BackupContents";
import { DriveCatalogue } from "./DriveCatalogue";
import { DriveMore } from "./DriveMore";
import { DriveWatch } from "./DriveWatch";
import { Outcome } from "./Parameters";
import { Reasoned } from "./Reasoned";
import { Sure } from "./Sure";

export function DriveTools({ drive }: { drive: Drive }) {
  const path = `/drives/${encodeURIComponent(drive.id)}`;
  return (
    <>
      <Jog drive={drive} path={path} />
      <DriveWatch path={path} />
      <Backups drive={drive} path={path} />
      <DriveCatalogue path={path} />
      <DriveMore drive={drive} path={path} />
      <details class="part acts">
        <summary>{t("lockout")}</summary>
        <Reasoned
          decisions={[
            drive.lockout
              ? { label: t("lift_lockout"), needs: "DELETE /drives/{drive}/lockout", bare: true, grave: true, does: () => call("DELETE", `${path}/lockout`) }
              : { label: t("lock_out"), needs: "POST /drives/{drive}/lockout", grave: true, does: (reason) => post(`${path}/lockout`, { reason }) },
          ]}
        />
      </details>
    </>
  );
}

/** The key is said to be held so often, ms; the axis stops by itself when it is not. */
const HELD = 200;

/** Runs as long as the button is held: let go, hidden or left, it is released. It is not disabled while held: it would not be told. */
function Jog({ drive, path }: { drive: Drive; path: string }) {
  const asking = useAsking();
  const way = useSignal<"cw" | "ccw" | null>(null);
  const held = useRef<{ jog: string | null; timer: number } | null>(null);
  const release = (): void => {
    const now = held.current;
    held.current = null;
    way.value = null;
    if (!now) return;
    window.clearInterval(now.timer);
    if (now.jog !== null) void asking.ask(() => call("DELETE", `${path}/jog/${now.jog}`), "");
  };
  useEffect(() => {
    window.addEventListener("blur", release);
    document.addEventListener("visibilitychange", release);
    return () => {
      window.removeEventListener("blur", release);
      document.removeEventListener("visibilitychange", release);
      release();
    };
  }, [path]);
  const press = async (direction: "cw" | "ccw"): Promise<void> => {
    if (held.current) return;
    const mine = { jog: null as string | null, timer: 0 };
    held.current = mine;
    way.value = direction;
    await asking.ask(async () => {
      const { jog } = await post<{ jog: string }>(`${path}/jog`, { direction });
      mine.jog = jog;
      if (held.current !== mine) {
        await call("DELETE", `${path}/jog/${jog}`);
        return;
      }
      mine.timer = window.setInterval(() => void post(`${path}/jog/${jog}`).catch(release), HELD);
    }, "");
    if (asking.error.value) release();
  };
  return (
    <section class="part">
      <h3>{t("jog")}</h3>
      <div class="acts-row">
        {(["ccw", "cw"] as const).map((direction) => (
          <Button
            needs="POST /drives/{drive}/jog"
            key={direction}
            class="jog"
            aria-pressed={way.value === direction}
            {...(way.value === null ? stopped(againstDrive(drive, "jog", around())) : {})}
            onPointerDown={(event) => {
              event.currentTarget.setPointerCapture(event.pointerId);
              void press(direction);
            }}
            onPointerUp={release}
            onPointerCancel={release}
            onKeyDown={(event) => event.key === " " && !event.repeat && void press(direction)}
            onKeyUp={(event) => event.key === " " && release()}
          >
            {direction === "ccw" ? "◀ " : ""}
            {t(direction)}
            {direction === "cw" ? " ▶" : ""}
          </Button>
        ))}
        <small class="calm">{t("jog_hint")}</small>
      </div>
      <Told asking={asking} />
    </section>
  );
}

interface Difference {
  parameter: string;
  name?: string;
  here?: number | null;
  there?: number | null;
  [more: string]: unknown;
}

function Backups({ drive, path }: { drive: Drive; path: string }) {
  const again = useSignal(0);
  const operation = useSignal<Operation | null>(null);
  const label = useSignal("");
  const note = useSignal("");
  const other = useSignal("");
  const asking = useAsking();
  const { value } = useRead<{ items: Backup[] }>(`${path}/backups?limit=20`, again.value);
  const begin = (what: string, body: object, words: string): void => {
    label.value = words;
    operation.value = null;
    void asking.ask(async () => {
      let now = await post<Operation>(`${path}/${what}`, body);
      operation.value = now;
      while (now.state === "running") {
        now = await get<Operation>(`/operations/${encodeURIComponent(now.id)}?wait=2`);
        operation.value = now;
      }
      again.value++;
    }, "");
  };
  const differences = operation.value?.result["differences"] ?? operation.value?.result["rows"];
  const reading = stopped(againstDrive(drive, "read", around()));
  const others = driveList.value.filter(({ id }) => id !== drive.id);
  return (
    <details class="part acts">
      <summary>{t("backups")}</summary>
      <div class="stack">
        <div class="fields">
          <Field label={t("note")} value={note} />
          <div class="acts-row">
            <Button needs="POST /drives/{drive}/backups" onClick={() => begin("backups", { note: note.value.trim() }, t("back_up"))} {...reading}>
              {t("back_up")}
            </Button>
          </div>
        </div>
        {others.length > 0 && (
          <div class="fields">
            <label>
              <span>{t("compare_with")}</span>
              <select value={other.value} onChange={(event) => (other.value = event.currentTarget.value)}>
                <option value="">{t("choose")}</option>
                {others.map(({ id }) => (
                  <option key={id}>{id}</option>
                ))}
              </select>
            </label>
            <div class="acts-row">
              <Button needs="POST /drives/{drive}/compare" disabled={!other.value} onClick={() => begin("compare", { drive: other.value }, t("compare"))} {...reading}>
                {t("compare")}
              </Button>
            </div>
          </div>
        )}
        {value?.items.map((backup) => (
          <div key={backup.id} class="acts-row" data-backup={backup.id}>
            <span>
              #{backup.id} · {clock(backup.at)} · {backup.actor} {backup.note}
            </span>
            <Button needs="POST /drives/{drive}/compare" onClick={() => begin("compare", { backup: backup.id }, t("compare"))} {...reading}>
              {t("compare")}
            </Button>
            <Button needs="POST /drives/{drive}/restore" onClick={() => begin("restore", { backup: backup.id, dry_run: true }, t("restore_dry"))} {...stopped(againstDrive(drive, "change", around()))}>
              {t("restore_dry")}
            </Button>
            <Sure needs="POST /drives/{drive}/restore" label={t("restore")} does={() => begin("restore", { backup: backup.id }, t("restore"))} {...stopped(againstDrive(drive, "write", around()))} />
            <BackupContents path={`${path}/backups/${backup.id}`} />
          </div>
        ))}
        <Told asking={asking} />
        {operation.value?.state === "running" && <small>{t("reading", operation.value.done, operation.value.total)}</small>}
        <Outcome operation={operation.value} label={label.value} />
        {Array.isArray(differences) && <Differences rows={differences as Difference[]} />}
      </div>
    </details>
  );
}

function Differences({ rows }: { rows: Difference[] }) {
  if (rows.length === 0) return <p class="calm">{t("no_differences")}</p>;
  const columns = [...new Set(rows.flatMap((row) => Object.keys(row)))];
  return (
    <table class="list">
      <thead>
        <tr>
          {columns.map((name) => (
            <th key={name}>
              <span>{name.replaceAll("_", " ")}</span>
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map((row, i) => (
          <tr key={i}>
            {columns.map((name) => (
              <td key={name}>{row[name] === null || row[name] === undefined ? "–" : String(row[name])}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
