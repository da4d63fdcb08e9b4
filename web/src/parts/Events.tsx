/** What has happened, newest first. */
import { none } from "../known";
import { clock } from "../shows";
import { happenings, selected } from "../store";
import { happening, said, t, tell } from "../texts";
import type { Happening } from "../types";

const BAD = /AlarmSet|Failed|VehicleHeld|VehicleRemoved|Abort/;
const GOOD = /TransferCompleted|AlarmCleared|VehicleReleased/;
const SHOWN = 80;

export function Events() {
  const list = happenings.value;
  return (
    <ol class="scroll events" reversed>
      {list.length === 0 && <li class="nothing">{none(t("no_events"))}</li>}
      {list.slice(0, SHOWN).map((event) => (
        <Line key={event.seq} event={event} />
      ))}
    </ol>
  );
}

function Line({ event }: { event: Happening }) {
  const tone = BAD.test(event.event) ? "bad" : GOOD.test(event.event) ? "good" : "";
  const where = [event.source, event.destination].filter(Boolean).join(" → ");
  return (
    <li data-event={event.seq}>
      <time>{clock(event.ts)}</time>
      <span class="seq">#{event.seq}</span>
      <b class={tone}>{happening(event.event)}</b>
      {event.vehicle ? (
        <button type="button" class="text" onClick={() => (selected.value = { kind: "vehicle", id: event.vehicle as string })}>
          {event.vehicle}
        </button>
      ) : (
        <span />
      )}
      <span class="more">
        {[...new Set([event.job, event.carrier, where, event.result && said(event.result), tell(event.detail)])].filter(Boolean).join(" · ")}
      </span>
    </li>
  );
}
