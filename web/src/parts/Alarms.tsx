/** What is wrong now: cause, and what helps. */
import { clock } from "../shows";
import { selected, troubles } from "../store";
import { t, tell } from "../texts";
import type { Wrong } from "../alarms";

export function Alarms() {
  const list = troubles.value;
  return (
    <section class="room" aria-label={t("alarms")}>
      <div class="head">
        <h2>
          {t("alarms")} {list.length}
        </h2>
      </div>
      <ul class="scroll alarms" tabIndex={0} aria-label={t("alarms")}>
        {list.length === 0 && <li class="nothing">{t("no_alarms")}</li>}
        {list.map((wrong) => (
          <Line key={wrong.key} wrong={wrong} />
        ))}
      </ul>
    </section>
  );
}

function Line({ wrong }: { wrong: Wrong }) {
  const { kind, source } = wrong;
  return (
    <li data-alarm={wrong.key}>
      <span class={`sign ${wrong.grave ? "" : "wait"}`} title={t(wrong.grave ? "alarm" : "held")}>
        {wrong.grave ? "!" : "‖"}
      </span>
      <span>
        {kind === "controller" ? (
          <b>{t("controller")}</b>
        ) : (
          <button type="button" class="text" onClick={() => (selected.value = { kind, id: source })}>
            <b>{source}</b>
          </button>
        )}{" "}
        {tell(wrong.cause)} {wrong.since && <small class="calm">· {clock(wrong.since)}</small>}
      </span>
      {wrong.remedy && <p class="remedy">{tell(wrong.remedy)}</p>}
    </li>
  );
}
