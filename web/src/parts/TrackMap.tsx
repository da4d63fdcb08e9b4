/** The live map with its buttons, its legend, and what is said of the thing under the pointer. */
import { effect, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { listenTo } from "../gestures";
import { Painter } from "../painter";
import { changes, devices, inPast, layout, lookAt, passers, presence, type Selection, selected, stations, track, vehicles } from "../store";
import { said, t, tell } from "../texts";
import { closedWays, previewedWays } from "../closed";
import type { Found } from "../find";
import { following, heatShown, layers } from "../layers";
import { moment } from "../past/player";
import * as heats from "../heats";
import * as planned from "../plan";
import { theme } from "../theme";
import { Finder } from "./Finder";
import { Keys } from "./Keys";
import { Layers } from "./Layers";
import { Legend } from "./Legend";

interface Tip {
  x: number;
  y: number;
  title: string;
  lines: string[];
}

function tipOf(hit: Selection, x: number, y: number): Tip | null {
  const lines = hit && linesFor(hit.kind, hit.id);
  return lines ? { x, y, title: hit.id, lines: lines.filter(Boolean) } : null;
}

function linesFor(kind: string, id: string): string[] | null {
  if (kind === "vehicle") {
    const vehicle = vehicles.get(id);
    if (!vehicle) return null;
    const load = vehicle.loaded ? (vehicle.carrier ?? t("loaded")) : t("empty");
    return [`${said(vehicle.activity)} · ${load}`, tell(vehicle.waiting), tell(vehicle.hold?.reason ?? "")];
  }
  if (kind === "device") {
    const device = devices.get(id);
    const charger = layout.value?.chargers.some((one) => one.id === id);
    return [`${t(charger ? "charger" : "door")} · ${t(`device_${lookAt(id)}`)}`, tell(device?.alarm || device?.reason || ""), passers(id).join(", ")];
  }
  const station = stations.get(id);
  if (!station) return null;
  const content = station.present === null ? t("unknown") : station.present ? (station.carrier ?? t("loaded")) : t("empty");
  const name = layout.value?.stations.find((one) => one.id === id)?.buffer;
  const buffer = name ? devices.get(name) : undefined;
  return [`${said(station.kind)} · ${content}`, buffer ? `${buffer.id} · ${t(`device_${lookAt(buffer.id)}`)}` : ""];
}

export function TrackMap() {
  const frame = useRef<HTMLDivElement>(null);
  const lower = useRef<HTMLCanvasElement>(null);
  const middle = useRef<HTMLCanvasElement>(null);
  const upper = useRef<HTMLCanvasElement>(null);
  const touch = useRef<HTMLDivElement>(null);
  const painter = useRef<Painter | null>(null);
  const tip = useSignal<Tip | null>(null);

  useEffect(() => {
    const box = frame.current as HTMLDivElement;
    const paint = new Painter(
      lower.current as HTMLCanvasElement,
      middle.current as HTMLCanvasElement,
      upper.current as HTMLCanvasElement,
    );
    painter.current = paint;
    const size = new ResizeObserver(() => paint.resize(box.clientWidth, box.clientHeight));
    size.observe(box);
    const stops = [
      planned.begin(),
      heats.begin(),
      effect(() => {
        void track.value;
        paint.load();
      }),
      effect(() => {
        void changes.vehicles.value;
        void track.value;
        paint.report();
      }),
      effect(() => {
        void changes.stations.value;
        void changes.devices.value;
        void presence.value;
        void selected.value;
        void layers.value;
        void heatShown.value;
        void heats.heatKept.value;
        void closedWays.value;
        void previewedWays.value;
        void planned.plan.value;
        paint.redraw();
      }),
      effect(() => {
        void theme.value;
        paint.recolour();
      }),
      effect(() => {
        void inPast.value;
        paint.forgetAll();
        paint.report();
      }),
      effect(() => {
        void moment.value;
        paint.wake();
      }),
      effect(() => {
        void following.value;
        paint.move();
      }),
      listenTo(touch.current as HTMLDivElement, paint, (hit, x, y) => (tip.value = tipOf(hit, x, y))),
    ];
    return () => {
      size.disconnect();
      for (const stop of stops) stop();
      paint.stop();
    };
  }, []);

  const zoom = (factor: number): void => {
    const paint = painter.current;
    paint?.view.zoom(factor, paint.view.width / 2, paint.view.height / 2);
    paint?.move();
  };
  const go = (found: Found): void => {
    if (found.kind !== "barcode") painter.current?.centre({ kind: found.kind, id: found.id });
    else painter.current?.centre({ kind: "station", id: found.id });
  };
  const pick = selected.value;
  return (
    <div class="map" ref={frame}>
      <canvas ref={lower} aria-hidden="true" />
      <canvas ref={middle} aria-hidden="true" />
      <canvas ref={upper} class="front" aria-hidden="true" />
      <div ref={touch} class="touch" tabIndex={0} role="application" aria-label={t("map_label")} />
      <div class="map-tools">
        <button type="button" onClick={() => zoom(1.4)} aria-label={t("zoom_in")} title={t("zoom_in")}>
          +
        </button>
        <button type="button" onClick={() => zoom(1 / 1.4)} aria-label={t("zoom_out")} title={t("zoom_out")}>
          −
        </button>
        <button type="button" onClick={() => painter.current?.fit()}>
          {t("fit")}
        </button>
        <button
          type="button"
          aria-pressed={following.value}
          disabled={pick?.kind !== "vehicle"}
          title={t("follow_hint")}
          onClick={() => (following.value = !following.value)}
        >
          {t("follow")}
        </button>
        <Layers />
        <Finder go={go} />
        <Keys />
      </div>
      <Legend />
      {tip.value && (
        <div class="tip" style={{ left: `${tip.value.x}px`, top: `${tip.value.y}px` }}>
          <b>{tip.value.title}</b>
          {tip.value.lines.map((line) => (
            <div key={line}>{line}</div>
          ))}
        </div>
      )}
    </div>
  );
}
