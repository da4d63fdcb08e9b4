/** What routes keep off, whom that cuts off, and how vehicles are led round it: in the header in few words, in full among the closures. */
import { controller } from "../store";
import { room } from "../route";
import { t, tell } from "../texts";
import type { Controller } from "../types";

/** A line that begins with places or a station, told in the words of who reads it. */
function retold(line: string): string {
  const at = line.indexOf(": ");
  return at < 0 ? tell(line) : `${line.slice(0, at)}: ${tell(line.slice(at + 2))}`;
}

/** What the count of reasons is of: the same in the header and above the list. */
const keptTitle = (now: Controller): string => t("kept_off_title", now.kept_off.length, now.closed_places);

/** In the header, only if anything is the matter. */
export function KeptOff() {
  const now = controller.value;
  if (!now || now.kept_off.length + now.cut_off.length === 0) return null;
  const words = [
    ...(now.kept_off.length ? [`${t("kept_off")} ${now.kept_off.length}`] : []),
    ...(now.cut_off.length ? [t("stations_cut_off", now.cut_off.length)] : []),
  ];
  return (
    <button type="button" class={`kept ${now.cut_off.length ? "bad" : "wait"}`} title={[keptTitle(now), ...[...now.cut_off, ...now.kept_off].map(retold)].join("\n")} onClick={() => (room.value = "closures")}>
      {words.join(" · ")}
    </button>
  );
}

/** Every reason, every station cut off, and what was done about it. */
export function KeptList() {
  const now = controller.value;
  if (!now) return null;
  const led = [
    ...(now.led_round ? [t("led_round", now.led_round)] : []),
    ...(now.led_quicker ? [t("led_quicker", now.led_quicker)] : []),
    ...(now.slow_track ? [t("slow_track", now.slow_track)] : []),
    ...(now.weighed ? [t("weighed", now.weighed)] : []),
    ...(now.restrained_to != null ? [t("restrained_to", now.restrained_to)] : []),
  ];
  return (
    <>
      {now.cut_off.length > 0 && <Lines title={t("cut_off_now")} explained={t("cut_off_title")} lines={now.cut_off} sign="✕" tone="" />}
      {now.kept_off.length > 0 && <Lines title={t("kept_off")} explained={keptTitle(now)} lines={now.kept_off} sign="⤳" tone="wait" />}
      {led.length > 0 && (
        <p class="padded calm" data-led>
          {t("since_start")}: {led.join(" · ")}
        </p>
      )}
    </>
  );
}

function Lines({ title, explained, lines, sign, tone }: { title: string; explained: string; lines: string[]; sign: string; tone: string }) {
  return (
    <>
      <h2 class="sub" title={explained}>
        {title} {lines.length}
      </h2>
      <ul class="alarms" aria-label={title}>
        {lines.map((words) => (
          <li key={words}>
            <span class={`sign ${tone}`}>{sign}</span>
            <span>{retold(words)}</span>
          </li>
        ))}
      </ul>
    </>
  );
}

/** Why a station cannot be reached now; null: nothing says so. */
export function cutOff(id: string): string | null {
  return controller.value?.cut_off.find((words) => words.startsWith(`${id}: `)) ?? null;
}

export function CutOff({ id }: { id: string }) {
  const words = cutOff(id);
  return (
    words && (
      <p class="note alarm" data-cut-off={id}>
        <b>{t("not_reachable")}</b> {tell(words.slice(id.length + 2))}
      </p>
    )
  );
}
