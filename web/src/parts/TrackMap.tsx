/** The live map: two canvases, one for what stands still and one for what moves. */
import { effect, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { Glide } from "../glide";
import { type Body, paintGrant, paintPlant, paintVehicle, type Scene } from "../paint";
import { clustersOf, MARK } from "../places";
import { LOOKS, type Look, lookOf } from "../shows";
import { changes, type Selection, layout, selected, stations, track, vehicles } from "../store";
import { said, t, type Word } from "../texts";
import type { Vehicle } from "../types";
import { type Box, View } from "../view";

/** Room in px beyond the outermost marks: buttons and names. */
const MARGIN = { top: 66, side: 72, bottom: 30 };
/** Smooth enough, and half the work where there is no GPU: ms between two pictures. */
const PERIOD = 30;
const STILL = matchMedia("(prefers-reduced-motion: reduce)");

interface Tip {
  x: number;
  y: number;
  title: string;
  lines: string[];
}

/** Owns the canvases; drawn as often as the screen wants while something moves, and not at all else. */
class Painter {
  readonly view = new View();
  hovered: Selection = null;
  private scene: Scene | null = null;
  private readonly glides = new Map<string, Glide>();
  private readonly last = new Map<string, Vehicle>();
  private bodies: Body[] = [];
  private ground: CanvasRenderingContext2D;
  private front: CanvasRenderingContext2D;
  private stale = true;
  private frame = 0;
  private painted = 0;

  constructor(
    private readonly lower: HTMLCanvasElement,
    private readonly upper: HTMLCanvasElement,
  ) {
    this.ground = lower.getContext("2d") as CanvasRenderingContext2D;
    this.front = upper.getContext("2d") as CanvasRenderingContext2D;
  }

  resize(width: number, height: number): void {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    for (const canvas of [this.lower, this.upper]) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      canvas.getContext("2d")?.setTransform(ratio, 0, 0, ratio, 0, 0);
    }
    this.view.width = width;
    this.view.height = height;
    if (this.view.fitted) this.fit();
    this.redraw();
  }

  load(): void {
    if (!layout.value || !track.value) return;
    const clusters = clustersOf(layout.value, track.value);
    const marks = clusters.flatMap((cluster) => cluster.marks);
    this.scene = { layout: layout.value, track: track.value, marks, clusters };
    this.glides.clear();
    this.last.clear();
    this.fit();
    this.redraw();
  }

  fit(): void {
    if (this.scene) this.view.fit(boxOf(this.scene), MARGIN);
    this.redraw();
  }

  /** Something that stands still has changed. */
  redraw(): void {
    this.stale = true;
    this.wake();
  }

  wake(): void {
    if (!this.frame) this.frame = requestAnimationFrame(() => this.paint());
  }

  stop(): void {
    cancelAnimationFrame(this.frame);
  }

  /** Take the vehicles' newest reports. */
  report(): void {
    if (!this.scene) return;
    const now = performance.now() / 1000;
    for (const id of this.last.keys()) if (!vehicles.has(id)) this.forget(id);
    for (const vehicle of vehicles.values()) {
      if (this.last.get(vehicle.id) === vehicle) continue;
      this.last.set(vehicle.id, vehicle);
      let glide = this.glides.get(vehicle.id);
      if (!glide) {
        const top = this.scene.layout.vehicles.find((spec) => spec.id === vehicle.id)?.max_speed;
        this.glides.set(vehicle.id, (glide = new Glide(this.scene.track, top)));
      }
      const moving = vehicle.link.up && vehicle.activity === "moving";
      glide.report({ ...vehicle, moving }, now);
    }
    this.wake();
  }

  at(px: number, py: number): Selection {
    let best: Selection = null;
    let least = 20;
    for (const body of this.bodies) {
      const away = Math.hypot(this.view.px(body.spot.x) - px, this.view.py(body.spot.y) - py);
      if (away < least) [least, best] = [away, { kind: "vehicle", id: body.vehicle.id }];
    }
    if (best) return best;
    least = Math.max(9, 330 * this.view.scale);
    for (const mark of this.scene?.marks ?? []) {
      const away = Math.hypot(this.view.px(mark.x) - px, this.view.py(mark.y) - py);
      if (away < least) [least, best] = [away, { kind: "station", id: mark.id }];
    }
    return best;
  }

  private forget(id: string): void {
    this.last.delete(id);
    this.glides.delete(id);
  }

  private paint(): void {
    this.frame = 0;
    const { scene, view } = this;
    if (!scene) return;
    if (performance.now() - this.painted < PERIOD - 5) {
      this.wake();
      return;
    }
    this.painted = performance.now();
    const pick = selected.value;
    if (this.stale) {
      this.stale = false;
      const station = pick?.kind === "station" ? pick.id : null;
      paintPlant(this.ground, view, scene, (id) => stations.get(id), station);
    }
    const now = performance.now() / 1000;
    this.bodies = this.placed(scene, now);
    const ctx = this.front;
    ctx.clearRect(0, 0, view.width, view.height);
    const picked = (body: Body): boolean => pick?.kind === "vehicle" && pick.id === body.vehicle.id;
    const hovered = (body: Body): boolean => this.hovered?.kind === "vehicle" && this.hovered.id === body.vehicle.id;
    for (const body of this.bodies) paintGrant(ctx, view, scene.track, body, picked(body) || hovered(body));
    const pulse = STILL.matches ? 0 : (now % 1.4) / 1.4;
    for (const body of this.bodies) paintVehicle(ctx, view, body, picked(body), hovered(body), pulse);
    const alarm = this.bodies.some((body) => lookOf(body.vehicle) === "alarm");
    if (!STILL.matches && (alarm || [...this.glides.values()].some((glide) => glide.busy))) this.wake();
  }

  private placed(scene: Scene, now: number): Body[] {
    const bodies: Body[] = [];
    for (const vehicle of this.last.values()) {
      const length = Math.min(scene.layout.vehicles.find((spec) => spec.id === vehicle.id)?.length ?? 1000, 1200);
      const glide = vehicle.activity === "off_rail" ? undefined : this.glides.get(vehicle.id);
      const spot = glide?.drive(now, STILL.matches).middle(length * 0.41);
      if (spot) bodies.push({ vehicle, spot, length });
    }
    return bodies;
  }
}

/** What has to be seen: the track, and the marks beside it. */
function boxOf({ track, marks }: Scene): Box {
  const box = { ...track.box };
  for (const { x, y } of marks) {
    box.x0 = Math.min(box.x0, x - MARK);
    box.x1 = Math.max(box.x1, x + MARK);
    box.y0 = Math.min(box.y0, y - MARK);
    box.y1 = Math.max(box.y1, y + MARK);
  }
  return box;
}

function tipOf(hit: Selection, x: number, y: number): Tip | null {
  if (hit?.kind === "vehicle") {
    const vehicle = vehicles.get(hit.id);
    if (!vehicle) return null;
    const load = vehicle.loaded ? (vehicle.carrier ?? t("loaded")) : t("empty");
    const more = [vehicle.waiting, vehicle.hold?.reason ?? ""].filter(Boolean);
    return { x, y, title: vehicle.id, lines: [`${said(vehicle.activity)} · ${load}`, ...more] };
  }
  const station = hit && stations.get(hit.id);
  if (!station) return null;
  const content = station.present === null ? t("unknown") : station.present ? (station.carrier ?? t("loaded")) : t("empty");
  return { x, y, title: station.id, lines: [`${said(station.kind)} · ${content}`] };
}

export function TrackMap() {
  const frame = useRef<HTMLDivElement>(null);
  const lower = useRef<HTMLCanvasElement>(null);
  const upper = useRef<HTMLCanvasElement>(null);
  const painter = useRef<Painter | null>(null);
  const tip = useSignal<Tip | null>(null);

  useEffect(() => {
    const box = frame.current as HTMLDivElement;
    const paint = new Painter(lower.current as HTMLCanvasElement, upper.current as HTMLCanvasElement);
    painter.current = paint;
    const size = new ResizeObserver(() => paint.resize(box.clientWidth, box.clientHeight));
    size.observe(box);
    const stops = [
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
        void selected.value;
        paint.redraw();
      }),
      listenTo(upper.current as HTMLCanvasElement, paint, (next) => (tip.value = next)),
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
    paint?.redraw();
  };
  return (
    <div class="map" ref={frame}>
      <canvas ref={lower} aria-hidden="true" />
      <canvas ref={upper} tabIndex={0} role="img" aria-label={t("map")} />
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
        <Legend />
      </div>
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

/** Pointer, wheel and keys. Returns how to stop. */
function listenTo(canvas: HTMLCanvasElement, paint: Painter, show: (tip: Tip | null) => void): () => void {
  const ends = new AbortController();
  const { signal } = ends;
  let from: { x: number; y: number; moved: boolean } | null = null;
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      paint.view.zoom(Math.exp(-event.deltaY * 0.0015), event.offsetX, event.offsetY);
      paint.redraw();
    },
    { passive: false, signal },
  );
  canvas.addEventListener(
    "pointerdown",
    (event) => {
      from = { x: event.offsetX, y: event.offsetY, moved: false };
      canvas.setPointerCapture(event.pointerId);
    },
    { signal },
  );
  canvas.addEventListener(
    "pointermove",
    (event) => {
      const [x, y] = [event.offsetX, event.offsetY];
      if (from) {
        if (!from.moved && Math.hypot(x - from.x, y - from.y) < 4) return;
        paint.view.pan(x - from.x, y - from.y);
        from = { x, y, moved: true };
        show(null);
        paint.redraw();
        return;
      }
      paint.hovered = paint.at(x, y);
      canvas.style.cursor = paint.hovered ? "pointer" : "grab";
      show(tipOf(paint.hovered, Math.min(x + 14, paint.view.width - 250), Math.min(y + 14, paint.view.height - 90)));
      paint.wake();
    },
    { signal },
  );
  canvas.addEventListener(
    "pointerup",
    (event) => {
      if (from && !from.moved) selected.value = paint.at(event.offsetX, event.offsetY);
      from = null;
    },
    { signal },
  );
  canvas.addEventListener(
    "pointerleave",
    () => {
      paint.hovered = null;
      show(null);
      paint.wake();
    },
    { signal },
  );
  canvas.addEventListener("keydown", (event) => void (keyed(event.key, paint) && event.preventDefault()), { signal });
  return () => ends.abort();
}

function keyed(key: string, paint: Painter): boolean {
  const { view } = paint;
  const step = 60;
  const moves: Record<string, () => void> = {
    ArrowLeft: () => view.pan(step, 0),
    ArrowRight: () => view.pan(-step, 0),
    ArrowUp: () => view.pan(0, step),
    ArrowDown: () => view.pan(0, -step),
    "+": () => view.zoom(1.25, view.width / 2, view.height / 2),
    "-": () => view.zoom(0.8, view.width / 2, view.height / 2),
    "0": () => paint.fit(),
    Escape: () => (selected.value = null),
  };
  const move = moves[key];
  move?.();
  if (move) paint.redraw();
  return move !== undefined;
}

function Legend() {
  const looks = Object.keys(LOOKS) as Look[];
  return (
    <div class="legend">
      {looks.map((look) => (
        <span key={look}>
          <i class="dot" style={{ background: LOOKS[look] }} />
          {t(`look_${look}` as Word)}
        </span>
      ))}
      <span>
        <i class="box" />
        {t("legend_carrier")}
      </span>
      <span>
        <i class="zone" />
        {t("legend_zone")}
      </span>
    </div>
  );
}
