/** Drawing of stations and chargers, with what is believed of them, and their names. */
import { type Cluster, MARK, type Mark } from "../places";
import { type DeviceLook, lookOfDevice, signOfDevice } from "../shows";
import type { Device, Station } from "../types";
import type { Box, View } from "../view";
import { type Ctx, DEVICE_INK, font, INK, type Now, type Scene, text, widthOf } from "./ink";
import { boxOf, type Labels, type Place } from "./labels";

/** Below this scale a station is a dot, and only what is occupied or closed is told apart. */
const DOTS = 0.011;
/** Below this one their machines have no names. */
const NAMED = 0.012;
/** A line of letters, px. */
const FURTHER = 14;

/** `trouble`: what vehicles cover that stand there until somebody comes; names keep clear of it where they can. */
export function paintStations(ctx: Ctx, view: View, scene: Scene, now: Now, labels: Labels, trouble: Labels): void {
  const size = Math.max(7, MARK * view.scale);
  if (view.scale < DOTS) {
    paintDots(ctx, view, scene, now);
    return;
  }
  const buffers = new Map(scene.layout.stations.map((station) => [station.id, station.buffer]));
  const seen = scene.clusters.filter((cluster) => cluster.marks.some((mark) => near(view, mark)));
  const frames = seen.map((cluster) => frameOf(view, cluster, size));
  seen.forEach((cluster, i) => {
    const frame = frames[i] as Box;
    labels.block(frame);
    paintFrame(ctx, frame, cluster);
    for (const mark of cluster.marks) {
      const buffer = buffers.get(mark.id);
      if (mark.kind === "charger") paintCharger(ctx, view, mark, size, now);
      else paintMark(ctx, view, mark, size, now.station(mark.id), buffer ? now.device(buffer) : undefined);
      if (now.picked?.id === mark.id) paintPicked(ctx, view, mark, size);
    }
  });
  if (view.scale < NAMED) return;
  seen.forEach((cluster, i) => paintName(ctx, view, cluster, frames[i] as Box, labels, trouble));
}

function near(view: View, { x, y }: Mark): boolean {
  return view.sees({ x0: x, x1: x, y0: y, y1: y }, 120);
}

/** A whole fab at once: one path for each kind of dot. */
function paintDots(ctx: Ctx, view: View, scene: Scene, now: Now): void {
  const size = Math.max(1.6, MARK * view.scale * 1.1);
  const kinds: [string, (station: Station | undefined) => boolean][] = [
    [INK.mark, (station) => !station?.present && !station?.out_of_service],
    [INK.carrier, (station) => station?.present === true && !station.out_of_service],
    [INK.closed, (station) => Boolean(station?.out_of_service)],
  ];
  for (const [colour, is] of kinds) {
    ctx.fillStyle = colour;
    ctx.beginPath();
    for (const mark of scene.marks) {
      if (near(view, mark) && is(now.station(mark.id))) ctx.rect(view.px(mark.x) - size / 2, view.py(mark.y) - size / 2, size, size);
    }
    ctx.fill();
  }
  const picked = scene.marks.find((mark) => mark.id === now.picked?.id);
  if (picked) paintPicked(ctx, view, picked, 7);
}

function frameOf(view: View, cluster: Cluster, size: number): Box {
  const [xs, ys] = [cluster.marks.map((m) => view.px(m.x)), cluster.marks.map((m) => view.py(m.y))];
  const alone = cluster.marks[0]?.kind === "agv_buffer" || cluster.marks[0]?.kind === "charger";
  const pad = size * (alone ? 0.75 : 0.5) + Math.max(3, size * 0.3);
  return { x0: Math.min(...xs) - pad, y0: Math.min(...ys) - pad, x1: Math.max(...xs) + pad, y1: Math.max(...ys) + pad };
}

function paintFrame(ctx: Ctx, box: Box, cluster: Cluster): void {
  ctx.fillStyle = INK.frame;
  ctx.beginPath();
  const round = cluster.marks[0]?.kind === "sbfl" || cluster.marks[0]?.kind === "sbfr";
  ctx.roundRect(box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0, round ? 12 : 3);
  ctx.fill();
}

function paintPicked(ctx: Ctx, view: View, mark: Mark, size: number): void {
  ctx.strokeStyle = INK.picked;
  ctx.lineWidth = 2;
  const half = size * (mark.kind === "agv_buffer" || mark.kind === "charger" ? 0.75 : 0.5) + 4;
  ctx.strokeRect(view.px(mark.x) - half, view.py(mark.y) - half, half * 2, half * 2);
}

function paintMark(
  ctx: Ctx,
  view: View,
  mark: Mark,
  size: number,
  station: Station | undefined,
  buffer: Device | undefined,
): void {
  const [px, py] = [view.px(mark.x), view.py(mark.y)];
  ctx.save();
  ctx.translate(px, py);
  ctx.lineWidth = Math.max(1.2, size * 0.1);
  ctx.strokeStyle = station?.out_of_service ? INK.closed : station?.reserved ? INK.reserved : INK.mark;
  if (mark.kind === "agv_buffer") paintBay(ctx, mark, size, buffer);
  else shape(ctx, mark.kind, size);
  if (station?.present) paintLoad(ctx, mark.kind, size, station.verified);
  else if (station?.present === null) text(ctx, "?", 0, size * 0.26, INK.faint, font(Math.round(size * 0.75), 700));
  if (station?.out_of_service) strike(ctx, size);
  ctx.restore();
  if (buffer) paintTrouble(ctx, px, py, size, buffer, lookOfDevice(buffer));
  if (view.scale > 0.055 && mark.short) {
    const [lx, ly] = [px + mark.nx * size * 0.95, py + mark.ny * size * 0.95 + 3];
    text(ctx, mark.short, lx, ly, INK.text, font(10));
  }
}

function strike(ctx: Ctx, size: number): void {
  ctx.beginPath();
  ctx.moveTo(-size / 2, -size / 2);
  ctx.lineTo(size / 2, size / 2);
  ctx.stroke();
}

/** Ports are square; side buffers are round. */
function shape(ctx: Ctx, kind: string, size: number): void {
  ctx.beginPath();
  if (kind === "port") ctx.roundRect(-size / 2, -size / 2, size, size, size * 0.16);
  else ctx.arc(0, 0, size * 0.52, 0, 7);
  ctx.fillStyle = INK.ground;
  ctx.fill();
  ctx.stroke();
}

/** An AGV's buffer is a bay, open towards the tape; dashed while its device is not heard. */
function paintBay(ctx: Ctx, mark: Mark, size: number, buffer: Device | undefined): void {
  const half = size * 0.68;
  ctx.fillStyle = INK.ground;
  ctx.fillRect(-half, -half, half * 2, half * 2);
  ctx.save();
  ctx.rotate(Math.atan2(mark.ny, mark.nx) - Math.PI / 2);
  ctx.setLineDash(buffer && lookOfDevice(buffer) === "silent" ? [size * 0.3, size * 0.22] : []);
  ctx.lineCap = "butt";
  ctx.lineWidth = Math.max(1.8, size * 0.16);
  if (buffer?.lock) ctx.strokeStyle = INK.reserved;
  ctx.beginPath();
  ctx.moveTo(-half, -half);
  ctx.lineTo(-half, half);
  ctx.lineTo(half, half);
  ctx.lineTo(half, -half);
  ctx.stroke();
  ctx.restore();
}

/** A FOUP is a square; a cart has wheels. */
function paintLoad(ctx: Ctx, kind: string, size: number, verified: boolean): void {
  ctx.fillStyle = INK.carrier;
  ctx.globalAlpha = verified ? 1 : 0.92;
  const s = size * (kind === "agv_buffer" ? 0.72 : 0.54);
  if (kind !== "agv_buffer") ctx.fillRect(-s / 2, -s / 2, s, s);
  else {
    ctx.fillRect(-s / 2, -s / 2, s, s * 0.7);
    ctx.beginPath();
    for (const side of [-1, 1]) ctx.arc(side * s * 0.3, s * 0.36, s * 0.17, 0, 7);
    ctx.fill();
  }
  ctx.globalAlpha = 1;
}

/** A buffer that does not answer or is in error says so by a sign at its corner. */
function paintTrouble(ctx: Ctx, px: number, py: number, size: number, device: Device, look: DeviceLook): void {
  const sign = signOfDevice(device, look);
  if (!sign) return;
  const [x, y] = [px + size * 0.75, py - size * 0.75];
  ctx.fillStyle = DEVICE_INK[device?.alarm ? "error" : look];
  ctx.beginPath();
  ctx.arc(x, y, 6, 0, 7);
  ctx.fill();
  text(ctx, sign, x, y + 3.5, INK.ground, font(10, 700));
}

/** A charger is a flash in a diamond: filled while somebody charges, crossed out while it is out of service. */
function paintCharger(ctx: Ctx, view: View, mark: Mark, size: number, now: Now): void {
  const device = now.device(mark.id);
  const look = now.look(mark.id);
  const half = size * 0.85;
  ctx.save();
  ctx.translate(view.px(mark.x), view.py(mark.y));
  ctx.strokeStyle = device?.out_of_service ? INK.closed : DEVICE_INK[look];
  ctx.fillStyle = look === "charging" ? DEVICE_INK.charging : INK.ground;
  ctx.lineWidth = Math.max(1.4, size * 0.11);
  ctx.beginPath();
  ctx.moveTo(0, -half);
  ctx.lineTo(half, 0);
  ctx.lineTo(0, half);
  ctx.lineTo(-half, 0);
  ctx.closePath();
  ctx.fill();
  ctx.stroke();
  ctx.fillStyle = look === "charging" ? INK.ground : DEVICE_INK[look];
  flash(ctx, size * 1.05);
  if (device?.out_of_service) strike(ctx, size * 1.2);
  ctx.restore();
  if (device) paintTrouble(ctx, view.px(mark.x), view.py(mark.y), size, device, look);
}

function flash(ctx: Ctx, size: number): void {
  const s = size / 2;
  ctx.beginPath();
  ctx.moveTo(s * 0.25, -s);
  ctx.lineTo(-s * 0.5, s * 0.15);
  ctx.lineTo(-s * 0.02, s * 0.15);
  ctx.lineTo(-s * 0.25, s);
  ctx.lineTo(s * 0.5, -s * 0.15);
  ctx.lineTo(s * 0.02, -s * 0.15);
  ctx.closePath();
  ctx.fill();
}

/**
 * The name goes away from the track if there is room, else to another side of the frame, else nowhere. Where a vehicle in trouble
 * stands over all of these, it goes a line further off.
 */
function paintName(ctx: Ctx, view: View, cluster: Cluster, frame: Box, labels: Labels, trouble: Labels): void {
  const letters = font(view.scale > 0.045 ? 12 : 10.5, 600);
  const width = widthOf(ctx, cluster.name, letters);
  const half = width / 2;
  const more = view.scale > 0.055 && cluster.marks.some((mark) => mark.short) ? 13 : 0;
  const { nx, ny } = cluster.marks[0] as Mark;
  const [mx, my] = [(frame.x0 + frame.x1) / 2, (frame.y0 + frame.y1) / 2];
  const above = { x: mx, y: frame.y0 - 5 - (ny < -0.5 ? more : 0) };
  const below = { x: mx, y: frame.y1 + 12 + (ny > 0.5 ? more : 0) };
  const left = { x: frame.x0 - 5 - half - (nx < -0.5 ? more : 0), y: my + 4 };
  const right = { x: frame.x1 + 5 + half + (nx > 0.5 ? more : 0), y: my + 4 };
  const flat = Math.abs(ny) > Math.abs(nx);
  const first: Place = flat ? (ny < 0 ? above : below) : nx < 0 ? left : right;
  // Over or under a frame beside upright track, the name begins at the frame's edge: so it does not lie on the track.
  const away = nx < 0 ? frame.x1 - half : frame.x0 + half;
  const others = flat ? [left, right] : [{ ...above, x: away }, { ...below, x: away }, above, below];
  const room = [first, ...others].filter((one) => labels.free(boxOf(one, width)));
  const further = [above, below].flatMap(({ x, y }) => [x, left.x, right.x].map((at) => ({ x: at, y: y + (y < my ? -FURTHER : FURTHER) })));
  const clear = [...room, ...(room.length > 0 ? further : [])].filter((one) => trouble.free(boxOf(one, width)));
  const places = [...clear, ...room];
  const place = places[labels.take(places, width)];
  if (place) text(ctx, cluster.name, place.x, place.y, INK.text, letters);
}
