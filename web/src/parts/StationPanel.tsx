import { serverNow } from "../api";
import { span } from "../shows";
import { layout, orderFrom, orderTo, stationNow, tick } from "../store";
import { said, t } from "../texts";
import { Missing } from "./Away";
import { DeviceBody } from "./DevicePanel";
import { CutOff } from "./Kept";
import { Fact, Panel } from "./Panel";
import { Stage } from "./Stage";
import { StationWrite } from "./StationWrite";
import { Taught } from "./Taught";

export function StationPanel({ id }: { id: string }) {
  const now = stationNow(id);
  void tick.value;
  if (!now) return <Missing id={id} />;
  const buffer = layout.value?.stations.find((station) => station.id === id)?.buffer;
  const occupied = now.present === null ? t("unknown") : now.present ? t("yes") : t("no");
  return (
    <Panel title={now.id} tag={said(now.kind)} colour={now.present ? "var(--ink-carrier)" : "var(--ink-mark)"}>
      <CutOff id={id} />
      <dl>
        <Fact name={t("present")}>
          {occupied} <small>({now.verified ? t("verified") : t("believed")})</small>
        </Fact>
        <Fact name={t("carrier")}>{now.carrier ?? t("none")}</Fact>
        <Fact name={t("provenance")}>
          {said(now.provenance)}
          {now.at && <small> · {t("ago", span(serverNow() - Date.parse(now.at)))}</small>}
        </Fact>
        <Fact name={t("reserved")}>{now.reserved || t("no")}</Fact>
        <Fact name={t("out_of_service")}>{now.out_of_service || t("no")}</Fact>
        <Fact name={t("barcode")}>{now.barcode}</Fact>
        {now.target && (
          <Fact name={t("target")}>
            SHFT {now.target[0]} · ROTA {now.target[1]} · LIFT {now.target[2]} <small>v{now.target_version}</small>
          </Fact>
        )}
      </dl>
      <div class="buttons">
        <button type="button" onClick={() => orderFrom(id)}>
          {t("use_source")}
        </button>
        <button type="button" onClick={() => orderTo(id)}>
          {t("use_destination")}
        </button>
      </div>
      <Stage id={id} />
      <StationWrite key={`${now.id} ${now.at}`} station={now} />
      {now.kind === "port" && <Taught kind="station" id={id} />}
      {buffer && (
        <section class="part">
          <h3>
            {t("buffer")} {buffer}
          </h3>
          <DeviceBody id={buffer} />
        </section>
      )}
    </Panel>
  );
}
