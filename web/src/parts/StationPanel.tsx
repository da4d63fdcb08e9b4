import { serverNow } from "../api";
import { INK } from "../paint";
import { span } from "../shows";
import { order, stationNow, tick } from "../store";
import { said, t } from "../texts";
import { Fact, Panel } from "./Panel";

export function StationPanel({ id }: { id: string }) {
  const now = stationNow(id);
  void tick.value;
  if (!now) return null;
  const occupied = now.present === null ? t("unknown") : now.present ? t("yes") : t("no");
  return (
    <Panel title={now.id} tag={said(now.kind)} colour={now.present ? INK.carrier : INK.mark}>
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
        <button type="button" onClick={() => (order.source.value = id)}>
          {t("use_source")}
        </button>
        <button type="button" onClick={() => (order.destination.value = id)}>
          {t("use_destination")}
        </button>
      </div>
    </Panel>
  );
}
