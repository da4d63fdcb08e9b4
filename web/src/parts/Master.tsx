/** The plant as a whole: pause, stop all, resume; fires and earthquakes and their end. */
import { useSignal } from "@preact/signals";
import { post } from "../api";
import { controller } from "../store";
import { t, tell } from "../texts";
import { Reasoned } from "./Reasoned";

const FIRES = ["fire", "earthquake"] as const;

export function Master() {
  const open = useSignal(false);
  const now = controller.value;
  if (!now) return null;
  const emergencies = FIRES.filter((kind) => now.emergencies.some((words) => words.includes(kind)));
  return (
    <div class="layers master" onKeyDown={(event) => event.key === "Escape" && (open.value = false)}>
      <button type="button" aria-expanded={open.value} onClick={() => (open.value = !open.value)}>
        {t("master")}
      </button>
      {open.value && (
        <div role="group" aria-label={t("master")}>
          {now.emergencies.map((words) => (
            <p key={words} class="note alarm">
              {tell(words)}
            </p>
          ))}
          <Reasoned
            decisions={[
              { label: t("pause"), needs: "POST /controller/pause", does: (reason) => post("/controller/pause", { reason }) },
              { label: t("stop_all"), needs: "POST /controller/stop", grave: true, does: (reason) => post("/controller/stop", { reason }) },
              ...FIRES.filter((kind) => !emergencies.includes(kind)).map((kind) => ({
                label: t(`tell_${kind}`),
                needs: "POST /controller/emergency" as const,
                grave: true,
                does: (reason: string) => post("/controller/emergency", { kind, reason }),
              })),
              { label: t("resume"), needs: "POST /controller/resume", bare: true, does: () => post("/controller/resume") },
              ...emergencies.map((kind) => ({
                label: t(`release_${kind}`),
                needs: "POST /controller/emergency/release" as const,
                grave: true,
                does: (reason: string) => post("/controller/emergency/release", { kind, reason }),
              })),
            ]}
          />
        </div>
      )}
    </div>
  );
}
