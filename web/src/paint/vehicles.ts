/** Drawing of what moves: vehicles, the track they hold, and their names. */
import { LOOKS, type Look, lookOf } from "../shows";
import type { Spot, Track } from "../track";
import type { Vehicle } from "../types";
import type { Box, View } from "../view";
import { type Ctx, font, INK, text } from "./ink";
import { boxOf, Labels, type Place } from "./labels";
import { stroke } from "./plant";

/** A vehicle to draw; `spot` is the middle of its hull. */
export interface Body {
  vehicle: Vehicle;
  agv: boolean;
  spot: Spot;
  length: number;
}

/** The track that a vehicle holds ahead, from where it is drawn. */
export function paintGrant(ctx: Ctx, view: View, track: Track, body: Body, strong: boolean): void {
  const { vehicle } = body;
  const stops = [vehicle.barcode ?? "", ...vehicle.granted];
  const ways = stops.slice(1).flatMap((end, i) => track.way(stops[i] as string, end) ?? []);
  if (ways.length === 0) return;
  ctx.strokeStyle = LOOKS[lookOf(vehicle)];
  ctx.lineCap = "round";
  ctx.globalAlpha = strong ? 0.75 : 0.3;
  stroke(ctx, view, ways, Math.min(6, Math.max(2, 110 * view.scale)));
  ctx.globalAlpha = 1;
}

/** A vehicle: solid with a carrier aboard, hollow without. A hoist has a nose; an AGV, which drives both ways, has wheels. */
export function paintVehicle(ctx: Ctx, view: View, body: Body, picked: boolean, hovered: boolean, pulse: number): void {
  const { vehicle, spot, agv } = body;
  const look = lookOf(vehicle);
  const colour = LOOKS[look];
  const [length, width] = sizeOf(view, body);
  const [px, py] = [view.px(spot.x), view.py(spot.y)];
  ctx.save();
  ctx.translate(px, py);
  if (look === "alarm") ring(ctx, length * (0.75 + 0.25 * pulse), colour, 0.8 - 0.6 * pulse);
  if (picked || hovered) ring(ctx, length * 0.8, INK.picked, picked ? 0.95 : 0.5);
  ctx.rotate(spot.angle);
  if (agv) wheels(ctx, length, width);
  if (agv) deck(ctx, length, width);
  else hull(ctx, length, width);
  ctx.fillStyle = INK.ground;
  ctx.fill();
  ctx.globalAlpha = vehicle.loaded ? 1 : 0.3;
  ctx.fillStyle = colour;
  ctx.fill();
  ctx.globalAlpha = 1;
  ctx.strokeStyle = colour;
  ctx.lineWidth = 1.8;
  ctx.setLineDash(look === "gone" ? [3, 3] : []);
  ctx.stroke();
  ctx.setLineDash([]);
  if (vehicle.loaded) {
    const s = width * 0.56;
    ctx.fillStyle = INK.carrier;
    ctx.strokeStyle = INK.ground;
    ctx.lineWidth = 1.4;
    ctx.beginPath();
    ctx.rect(-s / 2 - (agv ? 0 : length * 0.06), -s / 2, s, s);
    ctx.fill();
    ctx.stroke();
  }
  ctx.restore();
}

function ring(ctx: Ctx, radius: number, colour: string, alpha: number): void {
  ctx.strokeStyle = colour;
  ctx.globalAlpha = alpha;
  ctx.lineWidth = 2;
  ctx.beginPath();
  ctx.arc(0, 0, radius, 0, 7);
  ctx.stroke();
  ctx.globalAlpha = 1;
}

/** A box that is the same at both ends. */
function deck(ctx: Ctx, length: number, width: number): void {
  ctx.beginPath();
  ctx.roundRect(-length / 2, -width / 2, length, width, width * 0.22);
}

function wheels(ctx: Ctx, length: number, width: number): void {
  const [long, thick] = [length * 0.24, Math.max(2.5, width * 0.16)];
  ctx.fillStyle = INK.arrow;
  for (const x of [-length * 0.42, length * 0.42 - long]) {
    ctx.fillRect(x, -width / 2 - thick - 1, long, thick);
    ctx.fillRect(x, width / 2 + 1, long, thick);
  }
}

/** A box with its nose forward. */
function hull(ctx: Ctx, length: number, width: number): void {
  const [l, w] = [length / 2, width / 2];
  ctx.beginPath();
  ctx.moveTo(-l, -w * 0.8);
  ctx.quadraticCurveTo(-l, -w, -l + w * 0.3, -w);
  ctx.lineTo(l - w * 0.7, -w);
  ctx.lineTo(l, 0);
  ctx.lineTo(l - w * 0.7, w);
  ctx.lineTo(-l + w * 0.3, w);
  ctx.quadraticCurveTo(-l, w, -l, w * 0.8);
  ctx.closePath();
}

const SIGNS: Partial<Record<Look, string>> = { alarm: "!", held: "‖", gone: "?", waiting: "…", charging: "↯" };
/** Height of a vehicle's name with its ground, px. */
const LINE = 15;

/**
 * Names beside their vehicles. One that is looked at or in trouble goes first; each stays on its side while there is room; where
 * there is none at all, the name is left out unless it is one of those.
 */
export class Signs {
  private readonly sides = new Map<string, number>();

  /** `still`: what the names of all that stands still take; they are covered only where there is no other room. */
  paint(ctx: Ctx, view: View, bodies: Body[], first: (body: Body) => boolean, still: Labels): void {
    const labels = new Labels();
    const seen = bodies.filter((body) => visible(view, body));
    for (const body of seen) labels.block(hullOf(view, body));
    const rank = (body: Body): number => (first(body) ? 0 : urgent(body) ? 1 : 2);
    for (const body of seen.toSorted((a, b) => rank(a) - rank(b))) {
      this.sign(ctx, view, body, rank(body) < 2, first(body), labels, still);
    }
  }

  private sign(ctx: Ctx, view: View, body: Body, must: boolean, ringed: boolean, labels: Labels, still: Labels): void {
    const { vehicle } = body;
    const look = lookOf(vehicle);
    const words = SIGNS[look] ? `${vehicle.id} ${SIGNS[look]}` : vehicle.id;
    ctx.font = font(11, 700);
    const width = ctx.measureText(words).width + 8;
    const places = placesFor(view, body, width, ringed);
    const side = this.sides.get(vehicle.id) ?? 0;
    const order = [side, ...places.keys()].filter((one) => one < places.length);
    const clear = order.filter((one) => labels.free(grown(places[one] as Place, width)));
    const found = clear.find((one) => still.free(grown(places[one] as Place, width))) ?? clear[0] ?? (must ? 0 : undefined);
    if (found === undefined) return;
    this.sides.set(vehicle.id, found);
    const { x, y } = places[found] as Place;
    labels.block(grown({ x, y }, width));
    ctx.fillStyle = "rgba(6, 11, 16, 0.82)";
    ctx.beginPath();
    ctx.roundRect(x - width / 2, y - 11.5, width, LINE, 4);
    ctx.fill();
    text(ctx, words, x, y, LOOKS[look], font(11, 700));
  }
}

function urgent(body: Body): boolean {
  const look = lookOf(body.vehicle);
  return look === "alarm" || look === "held";
}

function grown(place: Place, width: number): Box {
  return boxOf(place, width - 3);
}

function visible(view: View, { spot }: Body): boolean {
  const [px, py] = [view.px(spot.x), view.py(spot.y)];
  return px > -50 && py > -50 && px < view.width + 50 && py < view.height + 50;
}

const sizeOf = (view: View, { length, agv }: Body): [number, number] => [
  Math.max(17, length * 0.82 * view.scale),
  Math.max(agv ? 13 : 11, (agv ? 700 : 560) * view.scale),
];

function hullOf(view: View, body: Body): Box {
  const [length, width] = sizeOf(view, body);
  const [c, s] = [Math.abs(Math.cos(body.spot.angle)), Math.abs(Math.sin(body.spot.angle))];
  const [w, h] = [(length * c + width * s) / 2, (length * s + width * c) / 2];
  const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
  return { x0: px - w, x1: px + w, y0: py - h, y1: py + h };
}

/** Around the ring of one that is looked at. */
function ringOf(view: View, body: Body): Box {
  const radius = sizeOf(view, body)[0] * 0.8;
  const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
  return { x0: px - radius, x1: px + radius, y0: py - radius, y1: py + radius };
}

/** Beside the hull, across the track first; then a line further off. */
function placesFor(view: View, body: Body, width: number, ringed: boolean): Place[] {
  const hull = ringed ? ringOf(view, body) : hullOf(view, body);
  const [px, py] = [(hull.x0 + hull.x1) / 2, (hull.y0 + hull.y1) / 2];
  const above = { x: px, y: hull.y0 - 7 };
  const below = { x: px, y: hull.y1 + 15 };
  const right = { x: hull.x1 + 5 + width / 2, y: py + 4 };
  const left = { x: hull.x0 - 5 - width / 2, y: py + 4 };
  const across = Math.abs(Math.sin(body.spot.angle)) > 0.7;
  const near = across ? [right, left, above, below] : [above, below, right, left];
  return [...near, { x: px, y: above.y - LINE }, { x: px, y: below.y + LINE }];
}
