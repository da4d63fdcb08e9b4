/** Drawing of what stands still: track, zones, barcodes, and, over them, stations and doors. */
import type { Box, View } from "../view";
import type { Track, Vec, Way } from "../track";
import type { LayoutZone } from "../types";
import { paintDoors } from "./doors";
import { type Ctx, font, INK, type Now, type Scene, text, widthOf } from "./ink";
import { Labels, type Place } from "./labels";
import { paintStations } from "./stations";

/** Below this scale a whole fab is on the map, and what is small is left out. */
const FINE = 0.011;

/** Draws the plant; returns what room names and marks take, for those that are drawn over it. `trouble`: what names keep clear of. */
export function paintPlant(ctx: Ctx, view: View, scene: Scene, now: Now, trouble: Box[]): Labels {
  ctx.lineJoin = "round";
  const rail = Math.min(14, Math.max(view.scale < FINE ? 1.6 : 3, 260 * view.scale));
  ctx.lineCap = view.scale < FINE ? "butt" : "round";
  const ways = [...scene.track.ways.values()].filter((way) => view.sees(way.box));
  if (now.zones) paintZones(ctx, view, scene, rail);
  paintRails(ctx, view, scene.track, ways, rail);
  if (view.scale > FINE) paintArrows(ctx, view, scene.track, ways, rail);
  paintDots(ctx, view, scene.track, rail);
  const labels = new Labels();
  paintDoors(ctx, view, scene, now, labels);
  const kept = new Labels();
  for (const box of trouble) kept.block(box);
  paintStations(ctx, view, scene, now, labels, kept);
  nameBarcodes(ctx, view, scene.track, rail, labels);
  return labels;
}

/** Zones are broad bands under the track: no-stop and capped ones whole, soft ones dotted. */
function paintZones(ctx: Ctx, view: View, scene: Scene, rail: number): void {
  const width = Math.max(rail + (view.scale < FINE ? 3 : 8), 900 * view.scale);
  const of = (which: (zone: LayoutZone) => boolean): Way[] => scene.layout.zones.filter(which).flatMap((zone) => inside(scene.track, zone));
  ctx.strokeStyle = INK.zone;
  ctx.globalAlpha = 0.24;
  stroke(ctx, view, of((zone) => zone.no_stop && !zone.soft), width);
  ctx.globalAlpha = 0.15;
  stroke(ctx, view, of((zone) => !zone.no_stop && !zone.soft), width);
  ctx.strokeStyle = INK.soft;
  ctx.globalAlpha = 0.4;
  ctx.setLineDash([2, width * 0.8]);
  stroke(ctx, view, of((zone) => zone.soft !== null), width);
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}

function inside(track: Track, zone: LayoutZone): Way[] {
  const barcodes = new Set(zone.barcodes);
  return zone.barcodes.flatMap((barcode) =>
    (track.next.get(barcode) ?? []).filter((edge) => barcodes.has(edge.end)).flatMap((edge) => track.way(edge.start, edge.end) ?? []),
  );
}

/** Rail hangs and is hollow; tape lies on the floor and is thin. */
function paintRails(ctx: Ctx, view: View, track: Track, ways: Way[], rail: number): void {
  const hung = ways.filter((way) => !track.floor.has(way.edge.start));
  ctx.strokeStyle = INK.tape;
  stroke(ctx, view, ways.filter((way) => track.floor.has(way.edge.start)), Math.max(2.5, rail * 0.6));
  ctx.strokeStyle = INK.rail;
  stroke(ctx, view, hung, rail);
  if (rail <= 5) return;
  ctx.strokeStyle = INK.core;
  stroke(ctx, view, hung, rail * 0.45);
}

export function stroke(ctx: Ctx, view: View, ways: Iterable<Way>, width: number): void {
  ctx.lineWidth = width;
  ctx.beginPath();
  let [lastX, lastY] = [Number.NaN, Number.NaN];
  for (const { pts } of ways) {
    const first = pts[0] as Vec;
    if (first.x !== lastX || first.y !== lastY) ctx.moveTo(view.px(first.x), view.py(first.y));
    for (let i = 1; i < pts.length; i++) {
      const point = pts[i] as Vec;
      ctx.lineTo(view.px(point.x), view.py(point.y));
      [lastX, lastY] = [point.x, point.y];
    }
  }
  ctx.stroke();
}

/** One arrow where track is driven one way; two, back to back, where it is driven both ways. */
function paintArrows(ctx: Ctx, view: View, track: Track, ways: Way[], rail: number): void {
  ctx.strokeStyle = INK.arrow;
  ctx.lineWidth = Math.max(1.2, rail * 0.16);
  const size = Math.max(3, rail * 0.42);
  const every = Math.max(1500, 95 / view.scale);
  let gone = every / 2;
  let both = every;
  ctx.beginPath();
  for (const way of ways) {
    const { edge } = way;
    const double = track.twoWay(edge);
    if (double && edge.start > edge.end) continue;
    if (double) both += edge.length;
    else gone += edge.length;
    if ((double ? both : gone) < every) continue;
    if (double) both = 0;
    else gone = 0;
    const { x, y, angle } = track.along(way, edge.length / 2);
    const [px, py] = [view.px(x), view.py(y)];
    const apart = double ? size * 1.3 : 0;
    arrow(ctx, px + Math.cos(angle) * apart, py + Math.sin(angle) * apart, angle, size);
    if (double) arrow(ctx, px - Math.cos(angle) * apart, py - Math.sin(angle) * apart, angle + Math.PI, size);
  }
  ctx.stroke();
}

function arrow(ctx: Ctx, px: number, py: number, angle: number, size: number): void {
  const [c, s] = [Math.cos(angle) * size, Math.sin(angle) * size];
  ctx.moveTo(px - c * 0.5 + s, py - s * 0.5 - c);
  ctx.lineTo(px + c * 0.5, py + s * 0.5);
  ctx.lineTo(px - c * 0.5 - s, py - s * 0.5 + c);
}

function paintDots(ctx: Ctx, view: View, track: Track, rail: number): void {
  if (view.scale < FINE) return;
  for (const { x, y, park } of track.points.values()) {
    if (!park && view.scale <= 0.05) continue;
    if (!view.sees({ x0: x, x1: x, y0: y, y1: y })) continue;
    ctx.fillStyle = park ? INK.park : INK.arrow;
    ctx.beginPath();
    ctx.arc(view.px(x), view.py(y), park ? Math.max(1.6, rail * 0.16) : Math.max(1, rail * 0.1), 0, 7);
    ctx.fill();
  }
}

/** Barcodes and tags have their names where there is room: tags lie further apart. */
function nameBarcodes(ctx: Ctx, view: View, track: Track, rail: number, labels: Labels): void {
  const letters = font(10);
  if (view.scale <= 0.045) return;
  for (const [barcode, { x, y }] of track.points) {
    if (view.scale <= (track.floor.has(barcode) ? 0.045 : 0.085)) continue;
    const [px, py] = [view.px(x), view.py(y)];
    if (px < -50 || py < -50 || px > view.width + 50 || py > view.height + 50) continue;
    const width = widthOf(ctx, barcode, letters);
    const places = besides(track, barcode, rail * 0.5 + 5, width).map(({ x: dx, y: dy }) => ({ x: px + dx, y: py + dy }));
    const place = places[labels.take(places, width)];
    if (place) text(ctx, barcode, place.x, place.y, INK.faint, letters);
  }
}

/** Where a barcode's name can stand, from the barcode: on the sides where no track leaves. */
function besides(track: Track, barcode: string, away: number, width: number): Place[] {
  const angles = [
    ...(track.next.get(barcode) ?? [])
      .flatMap((edge) => track.way(edge.start, edge.end) ?? [])
      .map((way) => track.along(way, 0).angle),
    ...(track.before.get(barcode) ?? [])
      .flatMap((edge) => track.way(edge.start, edge.end) ?? [])
      .map((way) => track.along(way, way.edge.length).angle + Math.PI),
  ];
  const sides = [
    { angle: -Math.PI / 2, x: 0, y: -away },
    { angle: Math.PI / 2, x: 0, y: away + 8 },
    { angle: 0, x: away + width / 2, y: 3 },
    { angle: Math.PI, x: -away - width / 2, y: 3 },
  ];
  return sides.filter((side) => angles.every((angle) => Math.cos(angle - side.angle) < 0.6));
}
