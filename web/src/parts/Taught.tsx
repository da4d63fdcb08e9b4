/** What a port or a vehicle was taught: versions with their origin, compared with each other, and rolled back. */
import { useSignal } from "@preact/signals";
import { post } from "../api";
import { clock } from "../shows";
import { changes } from "../store";
import { said, t, tell } from "../texts";
import type { Comparison, PulsesVersion } from "../types";
import { Told, useAsking, useRead } from "./asking";
import { ByHand } from "./ByHand";
import { Changes, Pulses } from "./Pulses";
import { Reasoned } from "./Reasoned";

export function Taught({ kind, id }: { kind: "station" | "vehicle"; id: string }) {
  const open = useSignal(false);
  return (
    <details class="part acts" open={open.value} onToggle={(event) => (open.value = event.currentTarget.open)}>
      <summary>{t(kind === "station" ? "dest" : "offset")}</summary>
      {open.value && <Versions kind={kind} id={id} />}
    </details>
  );
}

function Versions({ kind, id }: { kind: "station" | "vehicle"; id: string }) {
  const name = encodeURIComponent(id);
  const path = kind === "station" ? `/stations/${name}/dest` : `/vehicles/${name}/offset`;
  const again = useSignal(0);
  const { value } = useRead<{ items: PulsesVersion[] }>(path, changes.teaching.value, changes.stations.value === 0, again.value);
  const old = useSignal<number | null>(null);
  const asking = useAsking();
  const list = [...(value?.items ?? [])].reverse();
  const newest = list[0];
  if (!value) return null;
  const byHand = <ByHand key={newest?.version} kind={kind} path={path} newest={newest} after={() => again.value++} />;
  if (!newest) {
    return (
      <div class="stack">
        <p class="nothing">{t("never_taught")}</p>
        {byHand}
      </div>
    );
  }
  const compare = old.value !== null && old.value !== newest.version ? `/teaching/compare/${kind}s/${name}/${old.value}/${newest.version}` : null;
  return (
    <div class="stack">
      <table class="bits versions">
        <tbody>
          {list.map((version) => (
            <tr key={version.version} data-version={version.version}>
              <th>v{version.version}</th>
              <td>
                <Pulses axes={version} />
              </td>
              <td>
                {tell(said(version.source))} · {version.actor} · {clock(version.at)}
                {version.restores !== null && ` · = v${version.restores}`}
                {version.reason && ` · ${version.reason}`}
                {version.basis.map((basis) => (
                  <small key={basis.axis} class="basis">
                    {basis.axis.toUpperCase()} {basis.raw} − {basis.less ?? 0} ({basis.vehicle} @ {basis.barcode})
                  </small>
                ))}
                {version !== newest && (
                  <button type="button" class="text" onClick={() => (old.value = version.version)}>
                    {t("compare")}
                  </button>
                )}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      {compare && <Compared path={compare} />}
      {compare && (
        <Reasoned
          asking={asking}
          decisions={[
            {
              label: t("roll_back", old.value ?? 0),
              needs: kind === "station" ? "POST /stations/{station}/dest/rollback" : "POST /vehicles/{vehicle}/offset/rollback",
              grave: true,
              does: async (reason) => {
                await post(`${path}/rollback`, { version: old.value, reason }, { "If-Match": `"${newest.version}"` });
                old.value = null;
                again.value++;
              },
            },
          ]}
        />
      )}
      {!compare && <Told asking={asking} />}
      {byHand}
    </div>
  );
}

function Compared({ path }: { path: string }) {
  const { value } = useRead<Comparison>(path);
  if (!value) return null;
  return (
    <div class="stack">
      <p>
        <b>
          v{value.old.version} → v{value.new.version}
        </b>{" "}
        <Pulses axes={value.differences} signed />
      </p>
      <Changes changes={value.changes} />
    </div>
  );
}

