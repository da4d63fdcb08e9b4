/** Says over the page that the controller does not answer, and of when what stands there is. */
import { answered, away, lastHeard, none } from "../known";
import { heardAt, inPast, link, tick } from "../store";
import { span } from "../shows";
import { t } from "../texts";
import { Panel } from "./Panel";

export function Away() {
  void tick.value;
  if (inPast.value || (answered.value && !away.value)) return null;
  const never = !answered.value;
  if (never && link.value !== "lost") return null;
  const words = never ? t("away_never") : t("away_since", lastHeard(), t("ago", span(Date.now() - heardAt.value)));
  return (
    <div class="banner away" role="alert" data-away={never ? "never" : "since"}>
      <b>{t("link_lost")}</b>
      <span>{words}</span>
    </div>
  );
}

/** In place of a thing's panel: that nothing is known of it, or that there is none. */
export function Missing({ id }: { id: string }) {
  return (
    <Panel title={id} tag={t("unknown")} colour="var(--dim)">
      <p class="nothing">{none(t("no_such"))}</p>
    </Panel>
  );
}
