/** What the plant is, how it does, whether what is shown is live, who looks at it. */
import { alarmCount, controller, ENDED, heardAt, inPast, jobList, layout, link, notice, recording, tick, unacknowledged, vehicleList } from "../store";
import { away, counted, lastHeard } from "../known";
import { LOOKS, type Look, lookOf } from "../shows";
import { room, ROOMS } from "../route";
import { Account } from "./Account";
import { KeptOff } from "./Kept";
import { Master, StopAll } from "./Master";
import { language, said, speak, t, tell, type Word } from "../texts";
import { choose, theme } from "../theme";

export function Header() {
  return (
    <header>
      <h1>
        <svg viewBox="0 0 32 32" width="24" height="24" aria-hidden="true">
          <path d="M3 8h26M16 8v8" stroke="var(--accent)" stroke-width="3" stroke-linecap="round" />
          <rect x="9" y="16" width="14" height="10" rx="2" fill="#f5b83d" />
        </svg>
        Hoistway
      </h1>
      <span class="plant">{layout.value?.name ?? ""}</span>
      <ControllerState />
      <KeptOff />
      {!inPast.value && <Master />}
      {!inPast.value && <StopAll />}
      <span class="grow" />
      <Counts />
      <Account />
      <Theme />
      <button type="button" class="plain" onClick={() => speak(language.value === "en" ? "ko" : "en")}>
        {language.value === "en" ? "KO" : "EN"}
      </button>
      <LinkState />
    </header>
  );
}

export function Rooms() {
  const alarms = alarmCount.value;
  return (
    <nav class="rooms" aria-label={t("rooms")}>
      {(recording.value ? (["playback"] as const) : ROOMS).map((name) => (
        <button type="button" key={name} aria-current={room.value === name ? "page" : undefined} onClick={() => (room.value = name)}>
          {t(name)}
          {name === "alarms" && alarms > 0 && (
            <b class="badge" title={t("alarm_count_title", unacknowledged.value)}>
              ! {alarms}
            </b>
          )}
        </button>
      ))}
    </nav>
  );
}

function Theme() {
  const other = theme.value === "dark" ? "light" : "dark";
  return (
    <button type="button" class="plain" title={t(`theme_${other}`)} aria-label={t(`theme_${other}`)} onClick={() => choose(other)}>
      {other === "light" ? "☀" : "☾"}
    </button>
  );
}

function ControllerState() {
  const now = controller.value;
  if (!now) return <span class="pill">{t("unknown")}</span>;
  const emergency = (now.emergencies ?? []).join(", ");
  const grave = now.trouble || emergency;
  const tone = grave ? "bad" : now.state === "auto" ? "good" : "wait";
  const roll = now.waiting_for.length ? t("waiting_for", now.waiting_for.join(", ")) : "";
  const why = tell(notice.value || grave || now.reason || roll);
  return (
    <>
      <span class={`pill ${away.value ? "" : tone}`} title={t("controller")}>
        {away.value ? t("state_then", said(now.state), lastHeard()) : said(now.state)}
      </span>
      <span class={`why ${grave ? "bad" : ""}`} role="status" title={why}>
        {why}
      </span>
    </>
  );
}

function Counts() {
  const looks = new Map<Look, number>();
  for (const vehicle of vehicleList.value) looks.set(lookOf(vehicle), (looks.get(lookOf(vehicle)) ?? 0) + 1);
  const open = jobList.value.filter((job) => !ENDED.has(job.state)).length;
  return (
    <span class="counts">
      <span>
        <b>{counted(vehicleList.value.length)}</b> {t("vehicles")}
      </span>
      {(["alarm", "held", "gone"] as const).map(
        (look) =>
          looks.has(look) && (
            <span key={look} style={{ color: LOOKS[look] }} title={t("look_count_title", t(`look_${look}` as Word))}>
              <b>{looks.get(look)}</b> {t(`look_${look}` as Word)}
            </span>
          ),
      )}
      <span>
        <b>{counted(open)}</b> {t("open_jobs")}
      </span>
    </span>
  );
}

function LinkState() {
  void tick.value;
  const state = link.value;
  if (inPast.value) {
    return (
      <span class={state === "lost" ? "link lost" : "link past"} role="status">
        <i class="dot" />
        {t(state === "lost" ? "past_away" : "playback")}
      </span>
    );
  }
  const age = heardAt.value ? Math.round((Date.now() - heardAt.value) / 1000) : null;
  const text =
    state === "live" ? t("live") : state === "connecting" ? t("connecting") : age === null ? t("lost_none") : t("lost_age", age);
  return (
    <span class={`link ${state}`} role="status" aria-live="polite">
      <i class="dot" />
      {text}
    </span>
  );
}
