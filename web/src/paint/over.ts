/** Drawing of what lies over the track and changes with the traffic: granted and planned ways, heat, what people have barred. */
import type { Heat, HeatKind } from "../heat";
import type { Look } from "../shows";
import type { Track, Way } from "../track";
import type { View } from "../view";
import { type Ctx, HEAT, INK, LOOK_INK } from "./ink";
import { stroke } from "./plant";
import { type Body, visible } from "./vehicles";

/** The track that vehicles hold ahead. One path a look, since there are many; those that are looked at stand out. */
export function paintGrants(ctx: Ctx, view: View, track: Track, bodies: Body[], strong: (body: Body) => boolean): void {
  const groups = new Map<Look, Way[]>();
  const width = Math.min(6, Math.max(view.scale < 0.011 ? 1.4 : 2, 110 * view.scale));
  ctx.lineCap = "round";
  ctx.lineJoin = "round";
  for (const body of bodies) {
    const ways = granted(track, body);
    if (ways.length === 0 || !ways.some((way) => view.sees(way.box))) continue;
    if (strong(body)) {
      ctx.strokeStyle = LOOK_INK[body.look];
      ctx.globalAlpha = 0.8;
      stroke(ctx, view, ways, width + 2);
    } else groups.set(body.look, [...(groups.get(body.look) ?? []), ...ways]);
  }
  ctx.globalAlpha = 0.38;
  for (const [look, ways] of groups) {
    ctx.strokeStyle = LOOK_INK[look];
    stroke(ctx, view, ways, width);
  }
  ctx.globalAlpha = 1;
}

function granted(track: Track, { vehicle }: Body): Way[] {
  const ways: Way[] = [];
  let here = vehicle.barcode ?? "";
  for (const step of vehicle.granted) {
    const way = track.way(here, step);
    if (way) ways.push(way);
    here = step;
  }
  return ways;
}

/** Where the chosen vehicle would go from the end of its grant: dashed, since nobody has granted it. */
export function paintPlan(ctx: Ctx, view: View, track: Track, path: string[]): void {
  const ways = path.slice(1).flatMap((end, i) => track.way(path[i] as string, end) ?? []);
  ctx.strokeStyle = INK.plan;
  ctx.lineCap = "butt";
  ctx.globalAlpha = 0.85;
  ctx.setLineDash([7, 5]);
  stroke(ctx, view, ways, Math.max(2, Math.min(3.5, 90 * view.scale)));
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}

/** The track behind each barcode in the colour of how much was waited, or how many came by. */
export function paintHeat(ctx: Ctx, view: View, track: Track, heat: Heat, kind: HeatKind): void {
  const steps: Way[][] = HEAT.map(() => []);
  for (const [barcode, share] of heat.shares(kind)) {
    const step = Math.min(HEAT.length - 1, Math.floor(share * HEAT.length));
    for (const edge of track.before.get(barcode) ?? []) {
      const way = track.way(edge.start, edge.end);
      if (way && view.sees(way.box)) steps[step]?.push(way);
    }
  }
  ctx.lineCap = "round";
  ctx.globalAlpha = 0.85;
  steps.forEach((ways, i) => {
    ctx.strokeStyle = HEAT[i] as string;
    stroke(ctx, view, ways, Math.max(3 + i, 330 * view.scale));
  });
  ctx.globalAlpha = 1;
}

/** Closed track: crossed out, so that it is seen without its colour. */
export function paintClosed(ctx: Ctx, view: View, track: Track, ways: Way[]): void {
  ctx.strokeStyle = INK.closed;
  ctx.lineCap = "butt";
  ctx.globalAlpha = 0.9;
  stroke(ctx, view, ways, Math.max(3, 200 * view.scale));
  ctx.globalAlpha = 1;
  ctx.lineWidth = 1.6;
  ctx.beginPath();
  let last = -1000;
  for (const way of ways) {
    const { x, y } = track.along(way, way.edge.length / 2);
    const [px, py] = [view.px(x), view.py(y)];
    if (Math.abs(px + py - last) < 18) continue;
    last = px + py;
    ctx.moveTo(px - 6, py - 6);
    ctx.lineTo(px + 6, py + 6);
    ctx.moveTo(px + 6, py - 6);
    ctx.lineTo(px - 6, py + 6);
  }
  ctx.stroke();
}

/** Vehicles that people have stopped or locked out: a bracket around each. */
export function paintHolds(ctx: Ctx, view: View, bodies: Body[]): void {
  ctx.lineWidth = 2;
  ctx.strokeStyle = LOOK_INK.held;
  ctx.beginPath();
  for (const body of bodies) {
    if (!visible(view, body) || !(body.vehicle.hold || body.vehicle.lockout)) continue;
    const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
    const r = Math.max(10, 900 * view.scale);
    for (const side of [-1, 1]) {
      ctx.moveTo(px + side * r * 0.5, py - r);
      ctx.lineTo(px + side * r, py - r);
      ctx.lineTo(px + side * r, py + r);
      ctx.lineTo(px + side * r * 0.5, py + r);
    }
  }
  ctx.stroke();
}

/** Track that somebody thinks of closing. */
export function paintPreviewed(ctx: Ctx, view: View, ways: Way[]): void {
  ctx.strokeStyle = INK.closed;
  ctx.lineCap = "butt";
  ctx.setLineDash([5, 4]);
  stroke(ctx, view, ways, Math.max(4, 260 * view.scale));
  ctx.setLineDash([]);
}
