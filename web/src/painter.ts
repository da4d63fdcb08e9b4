/** The live map: two canvases, one for what stands still and one for what moves. */
import { doorMarks } from "./doors";
import { Glide } from "./glide";
import type { Now, Scene } from "./paint/ink";
import { Labels } from "./paint/labels";
import { paintPlant } from "./paint/plant";
import { wingOf } from "./paint/doors";
import { type Body, paintGrant, paintVehicle, Signs } from "./paint/vehicles";
import { clustersOf, MARK } from "./places";
import { lookOf } from "./shows";
import { devices, layout, lookAt, type Selection, selected, stations, track, vehicles } from "./store";
import type { LayoutVehicle, Vehicle } from "./types";
import { type Box, View } from "./view";

/** Room in px beyond the outermost marks: buttons and names. */
const MARGIN = { top: 66, side: 72, bottom: 30 };
/** Smooth enough, and half the work where there is no GPU: ms between two pictures. */
const PERIOD = 30;
const STILL = matchMedia("(prefers-reduced-motion: reduce)");

/** Owns the canvases; drawn as often as the screen wants while something moves, and not at all else. */
export class Painter {
  readonly view = new View();
  hovered: Selection = null;
  private scene: Scene | null = null;
  private readonly glides = new Map<string, Glide>();
  private readonly last = new Map<string, Vehicle>();
  private readonly signs = new Signs();
  private bodies: Body[] = [];
  private names = new Labels();
  private specs = new Map<string, LayoutVehicle>();
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
    const doors = doorMarks(layout.value, track.value);
    this.scene = { layout: layout.value, track: track.value, marks, clusters, doors };
    this.specs = new Map(layout.value.vehicles.map((spec) => [spec.id, spec]));
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
        glide = new Glide(this.scene.track, this.specs.get(vehicle.id)?.max_speed);
        this.glides.set(vehicle.id, glide);
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
    least = wingOf(this.view);
    for (const door of this.scene?.doors ?? []) {
      const away = Math.hypot(this.view.px(door.x) - px, this.view.py(door.y) - py);
      if (away < least) [least, best] = [away, { kind: "device", id: door.id }];
    }
    least = Math.max(9, 330 * this.view.scale);
    for (const mark of this.scene?.marks ?? []) {
      const away = Math.hypot(this.view.px(mark.x) - px, this.view.py(mark.y) - py);
      if (away < least) [least, best] = [away, { kind: mark.kind === "charger" ? "device" : "station", id: mark.id }];
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
      const now: Now = {
        station: (id) => stations.get(id),
        device: (id) => devices.get(id),
        look: lookAt,
        picked: pick?.kind === "station" || pick?.kind === "device" ? pick : null,
      };
      this.names = paintPlant(this.ground, view, scene, now);
    }
    const now = performance.now() / 1000;
    this.bodies = this.placed(now);
    const ctx = this.front;
    ctx.clearRect(0, 0, view.width, view.height);
    const picked = (body: Body): boolean => pick?.kind === "vehicle" && pick.id === body.vehicle.id;
    const hovered = (body: Body): boolean => this.hovered?.kind === "vehicle" && this.hovered.id === body.vehicle.id;
    for (const body of this.bodies) paintGrant(ctx, view, scene.track, body, picked(body) || hovered(body));
    const pulse = STILL.matches ? 0 : (now % 1.4) / 1.4;
    for (const body of this.bodies) paintVehicle(ctx, view, body, picked(body), hovered(body), pulse);
    this.signs.paint(ctx, view, this.bodies, (body) => picked(body) || hovered(body), this.names);
    const alarm = this.bodies.some((body) => lookOf(body.vehicle) === "alarm");
    if (!STILL.matches && (alarm || [...this.glides.values()].some((glide) => glide.busy))) this.wake();
  }

  private placed(now: number): Body[] {
    const bodies: Body[] = [];
    for (const vehicle of this.last.values()) {
      const spec = this.specs.get(vehicle.id);
      const agv = spec?.kind === "agv";
      const length = Math.min(spec?.length ?? 1000, 1200);
      const glide = vehicle.activity === "off_rail" ? undefined : this.glides.get(vehicle.id);
      // A hoist lies behind the barcode that it reports; an AGV, which drives both ways, is drawn over its tag.
      const spot = glide?.drive(now, STILL.matches).middle(agv ? 0 : length * 0.41);
      if (spot) bodies.push({ vehicle, agv, spot, length });
    }
    return bodies;
  }
}

/** What has to be seen: the track, and the marks beside it. */
function boxOf({ track: drawn, marks }: Scene): Box {
  const box = { ...drawn.box };
  for (const { x, y } of marks) {
    box.x0 = Math.min(box.x0, x - MARK);
    box.x1 = Math.max(box.x1, x + MARK);
    box.y0 = Math.min(box.y0, y - MARK);
    box.y1 = Math.max(box.y1, y + MARK);
  }
  return box;
}
