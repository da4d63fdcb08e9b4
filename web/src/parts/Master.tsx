/** The plant as a whole: pause, stop all, resume; fires and earthquakes and their end. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { post } from "../api";
import { controller } from "../store";
import { t, tell } from "../texts";
import { Told, useAsking } from "./asking";
import { useClosed } from "./menu";
import { Reasoned } from "./Reasoned";
import { Sure } from "./Sure";

const FIRES = ["fire", "earthquake"] as const;

/** Everything stops, pressed twice and without a word: whoever sees something go wrong has no time to write why. */
export function StopAll() {
  const asking = useAsking();
  if (!controller.value) return null;
  return (
    <span class="stop-all">
      <Sure class="grave" needs="POST /controller/stop" label={t("stop_all")} does={() => void asking.ask(() => post("/controller/stop", { reason: t("stopped_here") }))} />
      <Told asking={asking} />
    </span>
  );
}

export function Master() {
  const open = useSignal(false);
  const asking = useAsking();
  const box = useClosed(open);
  const now = controller.value;
  const done = asking.done.value;
  useEffect(() => {
    if (done) open.value = false;
  }, [done]);
  if (!now) return null;
  const emergencies = FIRES.filter((kind) => now.emergencies.some((words) => words.includes(kind)));
  return (
    <div {...box} class="layers master">
      <button
        type="button"
        aria-expanded={open.value}
        onClick={() => {
          asking.done.value = "";
          open.value = !open.value;
        }}
      >
        {t("master")}
      </button>
      {open.value && (
        <div role="group" aria-label={t("master")}>
          {now.emergencies.map((words) => (
            <p key={words} class="note alarm">
              {tell(words)}
            </p>
          ))}
          <p class="calm">{t("reason_first")}</p>
          <Reasoned
            asking={asking}
            decisions={[
              { label: t("pause"), needs: "POST /controller/pause", does: (reason) => post("/controller/pause", { reason }) },
              { label: t("stop_all"), needs: "POST /controller/stop", grave: true, does: (reason) => post("/controller/stop", { reason }) },
              ...FIRES.filter((kind) => !emergencies.includes(kind)).map((kind) => ({
                label: t(`tell_${kind}`),
                needs: "POST /controller/emergency" as const,
                grave: true,
                does: (reason: string) => post("/controller/emergency", { kind, reason }),
              })),
              { label: t("resume"), needs: "POST /controller/resume", bare: true, idle: now.state === "auto", does: () => post("/controller/resume") },
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
