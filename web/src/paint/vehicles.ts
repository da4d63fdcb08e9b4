/** Drawing of what moves: vehicles and their names. A thousand are drawn in a few paths, one for each way to look. */
import { type Look, SIGNS } from "../shows";
import type { Spot } from "../track";
import type { Vehicle } from "../types";
import type { Box, View } from "../view";
import { type Ctx, font, INK, LOOK_INK, text, widthOf } from "./ink";
import { boxOf, Labels, type Place } from "./labels";

/** A vehicle to draw; `spot` is the middle of its hull. */
export interface Body {
  vehicle: Vehicle;
  look: Look;
  agv: boolean;
  spot: Spot;
  length: number;
}

/** Drawn last: what needs a person lies over what does not. */
const ORDER: Look[] = ["gone", "idle", "charging", "moving", "handling", "waiting", "held", "alarm"];

/** Vehicles: solid with a carrier aboard, hollow without. A hoist has a nose; an AGV, which drives both ways, has wheels. */
export function paintFleet(ctx: Ctx, view: View, bodies: Body[]): void {
  const groups = new Map<Look, Body[]>();
  for (const body of bodies) {
    const group = groups.get(body.look);
    if (group) group.push(body);
    else groups.set(body.look, [body]);
  }
  ctx.lineJoin = "round";
  for (const look of ORDER) {
    const group = groups.get(look);
    if (group) paintGroup(ctx, view, group, LOOK_INK[look], look === "gone");
  }
}

function paintGroup(ctx: Ctx, view: View, bodies: Body[], colour: string, dashed: boolean): void {
  if (sizeOf(view, bodies[0] as Body)[0] < SMALL) {
    paintSmall(ctx, view, bodies, colour);
    return;
  }
  const agvs = bodies.filter((body) => body.agv);
  if (agvs.length > 0) fill(ctx, INK.arrow, () => agvs.forEach((body) => wheels(ctx, view, body)));
  const loaded = bodies.filter((body) => body.vehicle.loaded);
  const empty = bodies.filter((body) => !body.vehicle.loaded);
  const hulls = (some: Body[]) => () => some.forEach((body) => hull(ctx, view, body));
  fill(ctx, INK.ground, hulls(empty));
  ctx.globalAlpha = 0.3;
  fill(ctx, colour, hulls(empty));
  ctx.globalAlpha = 1;
  fill(ctx, colour, hulls(loaded));
  ctx.strokeStyle = colour;
  ctx.lineWidth = 1.8;
  ctx.setLineDash(dashed ? [3, 3] : []);
  ctx.beginPath();
  hulls(bodies)();
  ctx.stroke();
  ctx.setLineDash([]);
  fill(ctx, INK.carrier, () => loaded.forEach((body) => load(ctx, view, body)));
  ctx.strokeStyle = INK.ground;
  ctx.lineWidth = 1.4;
  ctx.stroke();
}

/** A whole fab at once: wedges, with a dot where a carrier is aboard. */
function paintSmall(ctx: Ctx, view: View, bodies: Body[], colour: string): void {
  fill(ctx, colour, () => {
    for (const body of bodies) {
      const [length, width] = sizeOf(view, body);
      const [l, w] = [length / 2, width / 2];
      shape(ctx, view, body, body.agv ? [-l, -w, l, -w, l, w, -l, w] : [-l, -w, l, 0, -l, w]);
    }
  });
  fill(ctx, INK.carrier, () => {
    for (const { vehicle, spot } of bodies) {
      if (vehicle.loaded) ctx.rect(view.px(spot.x) - 1.5, view.py(spot.y) - 1.5, 3, 3);
    }
  });
}

function fill(ctx: Ctx, colour: string, path: () => void): void {
  ctx.fillStyle = colour;
  ctx.beginPath();
  path();
  ctx.fill();
}

/** A ring around one that is looked at, and a beat around one in alarm. */
export function paintRings(ctx: Ctx, view: View, bodies: Body[], strength: (body: Body) => number, pulse: number): void {
  for (const body of bodies) {
    const [length] = sizeOf(view, body);
    if (body.look === "alarm") ring(ctx, view, body, length * (0.75 + 0.25 * pulse), LOOK_INK.alarm, 0.8 - 0.6 * pulse);
    const alpha = strength(body);
    if (alpha > 0) ring(ctx, view, body, length * 0.8, INK.picked, alpha);
  }
}

function ring(ctx: Ctx, view: View, { spot }: Body, radius: number, colour: string, alpha: number): void {
  ctx.strokeStyle = colour;
  ctx.globalAlpha = alpha;
  ctx.lineWidth = 2;
  ctx.beginPath();
  ctx.arc(view.px(spot.x), view.py(spot.y), radius, 0, 7);
  ctx.stroke();
  ctx.globalAlpha = 1;
}

/** A closed shape around the vehicle: pairs along and across it, in px. */
function shape(ctx: Ctx, view: View, { spot }: Body, corners: number[]): void {
  const [px, py] = [view.px(spot.x), view.py(spot.y)];
  const [c, s] = [Math.cos(spot.angle), Math.sin(spot.angle)];
  for (let i = 0; i < corners.length; i += 2) {
    const [along, across] = [corners[i] as number, corners[i + 1] as number];
    const [x, y] = [px + along * c - across * s, py + along * s + across * c];
    if (i === 0) ctx.moveTo(x, y);
    else ctx.lineTo(x, y);
  }
  ctx.closePath();
}

/** A box with its nose forward, or, for an AGV, one that is the same at both ends. */
function hull(ctx: Ctx, view: View, body: Body): void {
  const [length, width] = sizeOf(view, body);
  const [l, w] = [length / 2, width / 2];
  if (body.agv) shape(ctx, view, body, [-l, -w, l, -w, l, w, -l, w]);
  else shape(ctx, view, body, [-l, -w * 0.8, -l + w * 0.2, -w, l - w * 0.7, -w, l, 0, l - w * 0.7, w, -l + w * 0.2, w, -l, w * 0.8]);
}

function wheels(ctx: Ctx, view: View, body: Body): void {
  const [length, width] = sizeOf(view, body);
  const [long, thick] = [length * 0.24, Math.max(2.5, width * 0.16)];
  for (const x of [-length * 0.42, length * 0.42 - long]) {
    for (const y of [-width / 2 - thick - 1, width / 2 + 1]) {
      shape(ctx, view, body, [x, y, x + long, y, x + long, y + thick, x, y + thick]);
    }
  }
}

/** The carrier aboard. */
function load(ctx: Ctx, view: View, body: Body): void {
  const [length, width] = sizeOf(view, body);
  const s = width * 0.28;
  const x = body.agv ? 0 : -length * 0.06;
  shape(ctx, view, body, [x - s, -s, x + s, -s, x + s, s, x - s, s]);
}

/** Shorter than this a hull has thin lines, px. */
const SMALL = 13;
/** From this scale on all vehicles have names; below it those do that are looked at or need a person. */
const NAMED = 0.014;
/** So few vehicles have names at any scale. */
const FEW = 60;
/** Height of a vehicle's name with its ground, px. */
const LINE = 15;

/** So many lines away from its vehicle a name is set at most where nothing nearer is free; a line leads to it. */
const FARTHEST = 8;

/**
 * Names beside their vehicles. One that is looked at or in trouble goes first; each stays on its side while there is room; where
 * there is none at all, the name is left out unless it is one of those: then it is set where both it and what stands still can be
 * read, with a line to its vehicle.
 */
export class Signs {
  private readonly sides = new Map<string, number>();

  /** `still`: whether a box is free of the names of what stands still; they are covered only where nothing around is free. `shown`: what is seen of the sheet. */
  paint(ctx: Ctx, view: View, seen: Body[], first: (body: Body) => boolean, still: (box: Box) => boolean, shown: Box): void {
    const labels = new Labels();
    const rank = (body: Body): number => (first(body) ? 0 : urgent(body) ? 1 : 2);
    const all = view.scale > NAMED || seen.length < FEW;
    const named = all ? seen : seen.filter((body) => rank(body) < 2).slice(0, FEW);
    for (const body of all ? seen : named) labels.block(hullOf(view, body));
    for (const body of named.toSorted((a, b) => rank(a) - rank(b))) {
      this.sign(ctx, view, body, rank(body) < 2, first(body), labels, still, shown);
    }
  }

  private sign(ctx: Ctx, view: View, body: Body, must: boolean, ringed: boolean, labels: Labels, still: (box: Box) => boolean, shown: Box): void {
    const { vehicle, look } = body;
    const words = SIGNS[look] ? `${vehicle.id} ${SIGNS[look]}` : vehicle.id;
    const width = widthOf(ctx, words, font(11, 700)) + 8;
    const places = placesFor(view, body, width, ringed);
    const side = this.sides.get(vehicle.id) ?? 0;
    const order = [side, ...places.keys()].filter((one) => one < places.length);
    const clear = order.filter((one) => labels.free(grown(places[one] as Place, width)));
    const free = (place: Place): boolean => labels.free(grown(place, width)) && still(grown(place, width));
    let found = clear.find((one) => still(grown(places[one] as Place, width)));
    if (found === undefined && must) {
      const near = places.length;
      places.push(...away(view, body, width, shown));
      const stays = side >= near && side < places.length && free(places[side] as Place);
      found = stays ? side : places.findIndex((place, one) => one >= near && free(place));
      if (found < 0) found = clear[0] ?? 0;
      else lead(ctx, view, body, places[found] as Place, LOOK_INK[look]);
    }
    if (found === undefined) return;
    this.sides.set(vehicle.id, found);
    const { x, y } = places[found] as Place;
    labels.block(grown({ x, y }, width));
    ctx.fillStyle = INK.plate;
    ctx.beginPath();
    ctx.roundRect(x - width / 2, y - 11.5, width, LINE, 4);
    ctx.fill();
    text(ctx, words, x, y, LOOK_INK[look], font(11, 700));
  }
}

/** What a vehicle in trouble covers, with its ring or brackets, px. */
export function coveredBy(view: View, body: Body): Box {
  const hull = hullOf(view, body);
  const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
  const r = Math.max(10, 900 * view.scale) + 2;
  return { x0: Math.min(hull.x0, px - r), x1: Math.max(hull.x1, px + r), y0: Math.min(hull.y0, py - r), y1: Math.max(hull.y1, py + r) };
}

export function urgent({ look }: Body): boolean {
  return look === "alarm" || look === "held";
}

function grown(place: Place, width: number): Box {
  return boxOf(place, width - 3);
}

export function visible(view: View, { spot }: Body): boolean {
  return view.sees({ x0: spot.x, x1: spot.x, y0: spot.y, y1: spot.y }, 50);
}

/** In px. On a whole fab they are smaller than they should be to be seen well, so that they do not lie on each other. */
const sizeOf = (view: View, { length, agv }: Body): [number, number] => {
  const least = view.scale < 0.02 ? Math.max(7.5, view.scale * 850) : 17;
  return [Math.max(least, length * 0.82 * view.scale), Math.max(least * (agv ? 0.76 : 0.65), (agv ? 700 : 560) * view.scale)];
};

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

/** Around the hull, nearest first, as far as the map is seen. */
function away(view: View, { spot }: Body, width: number, shown: Box): Place[] {
  const [px, py] = [view.px(spot.x), view.py(spot.y)];
  const places: Place[] = [];
  for (let line = 2; line <= FARTHEST; line++) {
    for (let turn = 0; turn < 16; turn++) {
      const angle = (turn * Math.PI) / 8 - Math.PI / 2;
      const x = px + Math.cos(angle) * (line * LINE + width / 2);
      const y = py + 4 + Math.sin(angle) * line * LINE;
      const inside = x - width / 2 > shown.x0 && x + width / 2 < shown.x1 && y - LINE > shown.y0 && y + 4 < shown.y1;
      if (inside) places.push({ x, y });
    }
  }
  return places;
}

/** A line from the hull to its name. */
function lead(ctx: Ctx, view: View, body: Body, { x, y }: Place, colour: string): void {
  const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
  const [dx, dy] = [x - px, y - 4 - py];
  const from = (sizeOf(view, body)[0] * 0.55) / Math.max(1, Math.hypot(dx, dy));
  ctx.strokeStyle = colour;
  ctx.lineWidth = 1.4;
  ctx.beginPath();
  ctx.moveTo(px + dx * from, py + dy * from);
  ctx.lineTo(x, y - 4);
  ctx.stroke();
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
  const further = [-LINE, LINE].map((off) => ({ x: px, y: off < 0 ? above.y + off : below.y + off }));
  const aslant = [right.x, left.x].flatMap((x) => [above.y, below.y].map((y) => ({ x, y })));
  return [...near, ...further, ...aslant];
}
