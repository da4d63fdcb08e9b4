/** The live map: what stands still and what lies over it on sheets that are shifted, and what moves on a canvas of its own. */
import { closedWays, previewedWays } from "./closed";
import { doorMarks } from "./doors";
import { Glide } from "./glide";
import { Heat } from "./heat";
import { heatKept } from "./heats";
import { following, heatShown, layers } from "./layers";
import { dip, type Now, type Scene } from "./paint/ink";
import { Labels } from "./paint/labels";
import { wingOf } from "./paint/doors";
import { paintClosed, paintPreviewed, paintGrants, paintHeat, paintHolds, paintPlan } from "./paint/over";
import { paintPlant } from "./paint/plant";
import { type Body, coveredBy, paintFleet, paintRings, Signs, urgent, visible } from "./paint/vehicles";
import { plan } from "./plan";
import { clustersOf, MARK } from "./places";
import { Sheet } from "./sheet";
import { lookOf } from "./shows";
import { loading, moment, pace, playing, trails } from "./past/player";
import { devices, inPast, layout, lookAt, type Selection, selected, stations, track, vehicles } from "./store";
import type { Spot } from "./track";
import type { LayoutVehicle, Vehicle } from "./types";
import { type Box, View } from "./view";

/** Room in px beyond the outermost marks: buttons and names. */
const MARGIN = { top: 66, side: 72, bottom: 58 };
/** Vehicles are drawn anew at most and at least so often, ms: the map is shifted between, as often as the screen wants. */
const PERIOD = 30;
const SELDOM = 120;
/** The pace by which a vehicle goes across the map, mm/s. */
const FASTEST = 3000;
/** Below this scale only what is looked at shows its grant: others would be shorter than their vehicles. */
const GRANTS = 0.008;
/** What lies over the track follows the vehicles so often, ms. */
const OVER = 250;
/** A map that was moved is drawn as often as the screen wants for so long, ms. */
const MOVED = 400;
/** Somebody who looks for one thing sees it at least at this scale. */
const CLOSE = 0.03;
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
  private readonly ground: Sheet;
  private readonly over: Sheet;
  private readonly front: Sheet;
  /** Of what was seen on this page, and of what was played back. */
  private readonly heats = { now: new Heat(), then: new Heat() };
  private stale = true;
  private overAt = Number.NEGATIVE_INFINITY;
  /** Something was reported since what lies over the track was painted. */
  private overStale = true;
  private frame = 0;
  private painted = 0;
  private moved = Number.NEGATIVE_INFINITY;
  private namesAt = { scale: 0, x: 0, y: 0 };
  /** Vehicles in trouble that stand, and where, in words: the names of stations keep clear of them. */
  private stranded: Body[] = [];
  private strandedAt = "";
  private count = 0;

  constructor(
    lower: HTMLCanvasElement,
    middle: HTMLCanvasElement,
    upper: HTMLCanvasElement,
  ) {
    this.ground = new Sheet(lower, 400);
    this.over = new Sheet(middle, 320);
    this.front = new Sheet(upper, 120);
  }

  resize(width: number, height: number): void {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    for (const sheet of [this.ground, this.over, this.front]) sheet.resize(width, height, ratio);
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
    this.forgetAll();
    this.heats.now.clear();
    this.fit();
    this.redraw();
  }

  /** Another time is shown: vehicles do not drive from one into the other. */
  forgetAll(): void {
    this.glides.clear();
    this.last.clear();
    this.heats.then.clear();
    this.redraw();
  }

  fit(): void {
    if (this.scene) this.view.fit(boxOf(this.scene), MARGIN);
    this.redraw();
  }

  /** Something that stands still has changed. */
  redraw(): void {
    this.stale = true;
    this.overAt = Number.NEGATIVE_INFINITY;
    this.wake();
  }

  /** Somebody moves the map: it is shifted, and painted anew where that does not do. */
  move(): void {
    this.moved = performance.now();
    this.wake();
  }

  /** Other colours. */
  recolour(): void {
    dip();
    this.redraw();
  }

  /** Bring something into the middle. */
  centre({ kind, id }: NonNullable<Selection>): void {
    const spot = this.placeOf(kind, id);
    if (!spot) return;
    this.view.scale = Math.max(this.view.scale, CLOSE);
    this.view.centre(spot.x, spot.y);
    this.move();
  }

  private placeOf(kind: string, id: string): { x: number; y: number } | undefined {
    if (kind === "vehicle") return this.bodies.find((body) => body.vehicle.id === id)?.spot;
    const marks = [...(this.scene?.marks ?? []), ...(this.scene?.doors ?? [])];
    return marks.find((mark) => mark.id === id) ?? this.scene?.track.points.get(id);
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
    this.overStale = true;
    const then = inPast.value;
    const now = then ? moment.value : performance.now() / 1000;
    const heat = then ? this.heats.then : this.heats.now;
    for (const id of this.last.keys()) if (!vehicles.has(id)) this.forget(id);
    for (const vehicle of vehicles.values()) {
      if (this.last.get(vehicle.id) === vehicle) continue;
      this.last.set(vehicle.id, vehicle);
      heat.take(vehicle, now);
      if (then) continue;
      let glide = this.glides.get(vehicle.id);
      if (!glide) {
        glide = new Glide(this.scene.track, this.specs.get(vehicle.id)?.max_speed);
        this.glides.set(vehicle.id, glide);
      }
      const moving = vehicle.link.up && vehicle.activity === "moving";
      const { barcode, dist, granted } = vehicle;
      glide.report({ barcode, dist, granted, moving }, now);
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

  /** The barcode nearest to a place of the map. */
  barcodeAt(px: number, py: number): string | null {
    let best: string | null = null;
    let least = 25;
    for (const [barcode, { x, y }] of this.scene?.track.points ?? []) {
      const away = Math.hypot(this.view.px(x) - px, this.view.py(y) - py);
      if (away < least) [least, best] = [away, barcode];
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
    const ms = performance.now();
    const moving = ms - this.moved < MOVED;
    const due = ms - this.painted >= this.period() - 5;
    if (!moving && !due) {
      this.wake();
      return;
    }
    const pick = selected.value;
    if (following.value && pick?.kind === "vehicle") this.keepInMiddle(pick.id);
    if (!this.ground.follow(view, ms) || this.stale) this.paintGround(scene, ms);
    if (!this.front.follow(view, ms) || due) this.paintFront(ms);
    // After the vehicles: holds and granted track are drawn where they are now.
    const shown = this.over.follow(view, ms);
    if (!shown || (due && ms - this.overAt > OVER)) this.paintOver(scene, ms);
    this.front.canvas.dataset["pictures"] = String(++this.count);
    // Which moment of the past can be seen now, for whoever measures how long that takes.
    if (inPast.value && !loading.value) this.front.canvas.dataset["moment"] = String(moment.value);
    const alarm = this.bodies.some((body) => body.look === "alarm");
    const drives = inPast.value ? playing.value : [...this.glides.values()].some((glide) => glide.busy);
    const busy = !STILL.matches && (alarm || drives);
    if (busy || moving || this.stale || this.overStale || [this.ground, this.over, this.front].some((sheet) => sheet.blurred)) this.wake();
  }

  /** How long until the fastest vehicle has moved by a pixel: more often nothing would be seen to change, ms. */
  private period(): number {
    return Math.min(SELDOM, Math.max(PERIOD, 1000 / (FASTEST * (inPast.value ? pace.value : 1) * this.view.scale)));
  }

  private looked(body: Body): number {
    const pick = selected.value;
    if (pick?.kind === "vehicle" && pick.id === body.vehicle.id) return 0.95;
    return this.hovered?.kind === "vehicle" && this.hovered.id === body.vehicle.id ? 0.5 : 0;
  }

  private paintFront(ms: number): void {
    this.painted = ms;
    this.bodies = this.placed(ms / 1000);
    this.strand();
    const at = this.front.begin(this.view, ms);
    const { ctx } = this.front;
    const seen = this.bodies.filter((body) => visible(at, body));
    paintFleet(ctx, at, seen);
    const pulse = STILL.matches ? 0 : ((ms / 1000) % 1.4) / 1.4;
    paintRings(ctx, at, seen, (body) => this.looked(body), pulse);
    const free = (box: Box): boolean => this.names.free(this.onGround(box, at));
    const { margin } = this.front;
    const shown = { x0: margin, y0: margin, x1: at.width - margin, y1: at.height - margin };
    this.signs.paint(ctx, at, seen, (body) => this.looked(body) > 0, free, shown);
  }

  /** Note which vehicles in trouble stand where; what stands still is painted anew when that changes. */
  private strand(): void {
    this.stranded = this.bodies.filter((body) => urgent(body) && !this.glides.get(body.vehicle.id)?.busy);
    const at = this.stranded.map(({ vehicle, spot }) => `${vehicle.id} ${Math.round(spot.x / 100)} ${Math.round(spot.y / 100)}`).join();
    if (at !== this.strandedAt) this.stale = true;
    this.strandedAt = at;
  }

  private paintGround(scene: Scene, ms: number): void {
    this.stale = false;
    const pick = selected.value;
    const now: Now = {
      station: (id) => stations.get(id),
      device: (id) => devices.get(id),
      look: lookAt,
      picked: pick?.kind === "station" || pick?.kind === "device" ? pick : null,
      zones: layers.value.zones,
    };
    const at = this.ground.begin(this.view, ms);
    this.names = paintPlant(this.ground.ctx, at, scene, now, this.stranded.map((body) => coveredBy(at, body)));
    this.namesAt = { scale: at.scale, x: at.x, y: at.y };
  }

  private paintOver(scene: Scene, ms: number): void {
    this.overAt = ms;
    this.overStale = false;
    const at = this.over.begin(this.view, ms);
    const { ctx } = this.over;
    const { track: drawn } = scene;
    if (heatShown.value) paintHeat(ctx, at, drawn, heatKept.value ?? (inPast.value ? this.heats.then : this.heats.now), heatShown.value);
    if (layers.value.closures) {
      paintClosed(ctx, at, drawn, closedWays.value.flatMap(([start, end]) => drawn.way(start, end) ?? []));
    }
    if (previewedWays.value.length > 0) {
      paintPreviewed(ctx, at, previewedWays.value.flatMap(([start, end]) => drawn.way(start, end) ?? []));
    }
    if (plan.value.length > 0) paintPlan(ctx, at, drawn, plan.value);
    const strong = (body: Body): boolean => this.looked(body) > 0;
    const granted = this.view.scale > GRANTS ? this.bodies : this.bodies.filter(strong);
    if (layers.value.grants) paintGrants(ctx, at, drawn, granted, strong);
    if (layers.value.holds) paintHolds(ctx, at, this.bodies);
  }

  /** Where a box of a view lies on the sheet on which the names stand. */
  private onGround({ x0, x1, y0, y1 }: Box, view: View): Box {
    const { namesAt } = this;
    const k = namesAt.scale / view.scale;
    const [dx, dy] = [namesAt.x - view.x * k, namesAt.y - view.y * k];
    return { x0: x0 * k + dx, x1: x1 * k + dx, y0: y0 * k + dy, y1: y1 * k + dy };
  }

  private keepInMiddle(id: string): void {
    const spot = this.bodies.find((body) => body.vehicle.id === id)?.spot;
    if (spot) this.view.centre(spot.x, spot.y);
  }

  private spotOf({ id, activity }: Vehicle, back: number, now: number): Spot | null {
    if (activity === "off_rail" || !this.scene) return null;
    if (inPast.value) return trails.spot(this.scene.track, id, moment.value, back, STILL.matches);
    return this.glides.get(id)?.drive(now, STILL.matches).middle(back) ?? null;
  }

  private placed(now: number): Body[] {
    const bodies: Body[] = [];
    for (const vehicle of this.last.values()) {
      const spec = this.specs.get(vehicle.id);
      const agv = spec?.kind === "agv";
      const length = Math.min(spec?.length ?? 1000, 1200);
      // A hoist lies behind the barcode that it reports; an AGV, which drives both ways, is drawn over its tag.
      const back = agv ? 0 : length * 0.41;
      const spot = this.spotOf(vehicle, back, now);
      if (spot) bodies.push({ vehicle, look: lookOf(vehicle), agv, spot, length });
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
