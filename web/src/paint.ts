/** Drawing of the plant on a canvas: what stands still, and what moves. */
import { type Cluster, MARK, type Mark } from "./places";
import { LOOKS, type Look, lookOf } from "./shows";
import type { Spot, Track, Way } from "./track";
import type { Layout, Station, Vehicle } from "./types";
import type { Box, View } from "./view";

export const INK = {
  ground: "#0a1017",
  rail: "#33475b",
  core: "#0f1822",
  arrow: "#6d879f",
  zone: "#c98a2b",
  mark: "#5b7389",
  frame: "#1d2a38",
  text: "#9fb3c6",
  carrier: "#f7e3b0",
  reserved: "#ffd24d",
  closed: "#ff5c5c",
  picked: "#ffffff",
};
const FONT = '"Segoe UI", Roboto, "Noto Sans KR", "Malgun Gothic", Arial, system-ui, sans-serif';

type Ctx = CanvasRenderingContext2D;

export interface Scene {
  layout: Layout;
  track: Track;
  marks: Mark[];
  clusters: Cluster[];
}

/** A vehicle to draw; `spot` is the middle of its hull. */
export interface Body {
  vehicle: Vehicle;
  spot: Spot;
  length: number;
}

/** Track, zones, stations. */
export function paintPlant(
  ctx: Ctx,
  view: View,
  scene: Scene,
  station: (id: string) => Station | undefined,
  picked: string | null,
): void {
  ctx.clearRect(0, 0, view.width, view.height);
  ctx.lineCap = "round";
  ctx.lineJoin = "round";
  const rail = Math.min(14, Math.max(3, 260 * view.scale));
  for (const zone of scene.layout.zones) {
    const inside = new Set(zone.barcodes);
    const ways = [...scene.track.ways.values()].filter((w) => inside.has(w.edge.start) && inside.has(w.edge.end));
    ctx.strokeStyle = INK.zone;
    ctx.globalAlpha = zone.no_stop ? 0.2 : 0.12;
    stroke(ctx, view, ways, Math.max(rail + 8, 900 * view.scale));
    ctx.globalAlpha = 1;
  }
  const ways = [...scene.track.ways.values()];
  ctx.strokeStyle = INK.rail;
  stroke(ctx, view, ways, rail);
  if (rail > 5) {
    ctx.strokeStyle = INK.core;
    stroke(ctx, view, ways, rail * 0.45);
  }
  paintArrows(ctx, view, scene.track, ways, rail);
  paintBarcodes(ctx, view, scene.track, rail);
  paintStations(ctx, view, scene, station, picked);
}

function stroke(ctx: Ctx, view: View, ways: Iterable<Way>, width: number): void {
  ctx.lineWidth = width;
  ctx.beginPath();
  for (const way of ways) {
    way.pts.forEach((p, i) => (i ? ctx.lineTo(view.px(p.x), view.py(p.y)) : ctx.moveTo(view.px(p.x), view.py(p.y))));
  }
  ctx.stroke();
}

function paintArrows(ctx: Ctx, view: View, track: Track, ways: Way[], rail: number): void {
  ctx.strokeStyle = INK.arrow;
  ctx.lineWidth = Math.max(1.2, rail * 0.16);
  const size = Math.max(3, rail * 0.42);
  const every = Math.max(1500, 95 / view.scale);
  let gone = every / 2;
  ctx.beginPath();
  for (const way of ways) {
    gone += way.edge.length;
    if (gone < every) continue;
    gone = 0;
    const { x, y, angle } = track.along(way, way.edge.length / 2);
    const [px, py] = [view.px(x), view.py(y)];
    const [c, s] = [Math.cos(angle) * size, Math.sin(angle) * size];
    ctx.moveTo(px - c * 0.5 + s, py - s * 0.5 - c);
    ctx.lineTo(px + c * 0.5, py + s * 0.5);
    ctx.lineTo(px - c * 0.5 - s, py - s * 0.5 + c);
  }
  ctx.stroke();
}

function paintBarcodes(ctx: Ctx, view: View, track: Track, rail: number): void {
  const named = view.scale > 0.085;
  ctx.font = `10px ${FONT}`;
  ctx.textAlign = "center";
  for (const [barcode, { x, y, park }] of track.points) {
    const [px, py] = [view.px(x), view.py(y)];
    if (px < -50 || py < -50 || px > view.width + 50 || py > view.height + 50) continue;
    if (park || view.scale > 0.05) {
      ctx.fillStyle = park ? "#7fd1a8" : INK.arrow;
      ctx.beginPath();
      ctx.arc(px, py, park ? Math.max(1.6, rail * 0.16) : Math.max(1, rail * 0.1), 0, 7);
      ctx.fill();
    }
    if (named) {
      ctx.fillStyle = "#7f95a9";
      ctx.fillText(barcode, px, py - rail * 0.5 - 4);
    }
  }
}

function paintStations(
  ctx: Ctx,
  view: View,
  scene: Scene,
  station: (id: string) => Station | undefined,
  picked: string | null,
): void {
  const size = Math.max(7, MARK * view.scale);
  const taken = scene.clusters.map((cluster) => frameOf(view, cluster, size));
  scene.clusters.forEach((cluster, i) => {
    paintFrame(ctx, taken[i] as Box, cluster);
    for (const mark of cluster.marks) paintMark(ctx, view, mark, size, station(mark.id), mark.id === picked);
  });
  if (view.scale < 0.012) return;
  scene.clusters.forEach((cluster, i) => paintName(ctx, view, cluster, taken[i] as Box, taken));
}

function frameOf(view: View, cluster: Cluster, size: number): Box {
  const [xs, ys] = [cluster.marks.map((m) => view.px(m.x)), cluster.marks.map((m) => view.py(m.y))];
  const pad = size * 0.5 + Math.max(3, size * 0.3);
  return { x0: Math.min(...xs) - pad, y0: Math.min(...ys) - pad, x1: Math.max(...xs) + pad, y1: Math.max(...ys) + pad };
}

function paintFrame(ctx: Ctx, box: Box, cluster: Cluster): void {
  ctx.fillStyle = INK.frame;
  ctx.beginPath();
  ctx.roundRect(box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0, cluster.marks[0]?.kind === "port" ? 3 : 12);
  ctx.fill();
}

function paintMark(ctx: Ctx, view: View, mark: Mark, size: number, now: Station | undefined, picked: boolean): void {
  const [px, py] = [view.px(mark.x), view.py(mark.y)];
  ctx.save();
  ctx.translate(px, py);
  ctx.lineWidth = Math.max(1.2, size * 0.1);
  ctx.strokeStyle = now?.out_of_service ? INK.closed : now?.reserved ? INK.reserved : INK.mark;
  shape(ctx, mark.kind, size);
  ctx.fillStyle = INK.ground;
  ctx.fill();
  ctx.stroke();
  if (now?.present) {
    ctx.fillStyle = INK.carrier;
    ctx.globalAlpha = now.verified ? 1 : 0.92;
    const s = size * 0.54;
    ctx.fillRect(-s / 2, -s / 2, s, s);
  } else if (now && now.present === null) {
    text(ctx, "?", 0, size * 0.26, "#6b8196", `700 ${Math.round(size * 0.75)}px ${FONT}`);
  }
  if (now?.out_of_service) {
    ctx.beginPath();
    ctx.moveTo(-size / 2, -size / 2);
    ctx.lineTo(size / 2, size / 2);
    ctx.stroke();
  }
  if (picked) {
    ctx.strokeStyle = INK.picked;
    ctx.lineWidth = 2;
    ctx.strokeRect(-size / 2 - 4, -size / 2 - 4, size + 8, size + 8);
  }
  ctx.restore();
  if (view.scale > 0.055 && mark.short) {
    const [lx, ly] = [px + mark.nx * size * 0.95, py + mark.ny * size * 0.95 + 3];
    text(ctx, mark.short, lx, ly, INK.text, `10px ${FONT}`);
  }
}

/** Ports are square; side buffers are round. */
function shape(ctx: Ctx, kind: string, size: number): void {
  ctx.beginPath();
  if (kind === "port") ctx.roundRect(-size / 2, -size / 2, size, size, size * 0.16);
  else ctx.arc(0, 0, size * 0.52, 0, 7);
}

/** The name goes away from the track if there is room, else to another side of the frame, else nowhere. */
function paintName(ctx: Ctx, view: View, cluster: Cluster, frame: Box, taken: Box[]): void {
  const font = `600 ${view.scale > 0.045 ? 12 : 10.5}px ${FONT}`;
  ctx.font = font;
  const half = ctx.measureText(cluster.name).width / 2;
  const more = view.scale > 0.055 && cluster.marks.some((mark) => mark.short) ? 13 : 0;
  const { nx, ny } = cluster.marks[0] as Mark;
  const [mx, my] = [(frame.x0 + frame.x1) / 2, (frame.y0 + frame.y1) / 2];
  const above = { x: mx, y: frame.y0 - 5 - (ny < -0.5 ? more : 0) };
  const below = { x: mx, y: frame.y1 + 12 + (ny > 0.5 ? more : 0) };
  const left = { x: frame.x0 - 5 - half - (nx < -0.5 ? more : 0), y: my + 4 };
  const right = { x: frame.x1 + 5 + half + (nx > 0.5 ? more : 0), y: my + 4 };
  const flat = Math.abs(ny) > Math.abs(nx);
  const first = flat ? (ny < 0 ? above : below) : nx < 0 ? left : right;
  const others = flat ? [left, right] : [above, below];
  for (const { x, y } of [first, ...others]) {
    const box = { x0: x - half - 2, x1: x + half + 2, y0: y - 10, y1: y + 3 };
    if (taken.some((b) => b.x0 < box.x1 && b.x1 > box.x0 && b.y0 < box.y1 && b.y1 > box.y0)) continue;
    taken.push(box);
    text(ctx, cluster.name, x, y, INK.text, font);
    return;
  }
}

function text(ctx: Ctx, words: string, x: number, y: number, colour: string, font: string): void {
  ctx.font = font;
  ctx.textAlign = "center";
  ctx.fillStyle = colour;
  ctx.fillText(words, x, y);
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

/** A vehicle: solid with a carrier aboard, hollow without; its sign says what colour alone does not. */
export function paintVehicle(ctx: Ctx, view: View, body: Body, picked: boolean, hovered: boolean, pulse: number): void {
  const { vehicle, spot } = body;
  const look = lookOf(vehicle);
  const colour = LOOKS[look];
  const length = Math.max(17, body.length * 0.82 * view.scale);
  const width = Math.max(11, 560 * view.scale);
  const [px, py] = [view.px(spot.x), view.py(spot.y)];
  ctx.save();
  ctx.translate(px, py);
  if (look === "alarm") ring(ctx, length * (0.75 + 0.25 * pulse), colour, 0.8 - 0.6 * pulse);
  if (picked || hovered) ring(ctx, length * 0.8, INK.picked, picked ? 0.95 : 0.5);
  ctx.rotate(spot.angle);
  hull(ctx, length, width);
  ctx.fillStyle = "#0a1017";
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
    ctx.rect(-s / 2 - length * 0.06, -s / 2, s, s);
    ctx.fill();
    ctx.stroke();
  }
  ctx.restore();
  paintSign(ctx, px, py, spot.angle, width, vehicle, look, colour);
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

const SIGNS: Partial<Record<Look, string>> = { alarm: "!", held: "‖", gone: "?", waiting: "…" };

function paintSign(
  ctx: Ctx,
  px: number,
  py: number,
  angle: number,
  width: number,
  vehicle: Vehicle,
  look: Look,
  colour: string,
): void {
  const sign = SIGNS[look] ?? "";
  const label = sign ? `${vehicle.id} ${sign}` : vehicle.id;
  const font = `700 11px ${FONT}`;
  ctx.font = font;
  const w = ctx.measureText(label).width + 8;
  const across = Math.abs(Math.sin(angle)) > 0.7;
  const x = across ? px + width / 2 + 5 + w / 2 : px;
  const y = across ? py : py - width / 2 - 11;
  ctx.fillStyle = "rgba(6, 11, 16, 0.82)";
  ctx.beginPath();
  ctx.roundRect(x - w / 2, y - 7.5, w, 15, 4);
  ctx.fill();
  text(ctx, label, x, y + 4, colour, font);
}
