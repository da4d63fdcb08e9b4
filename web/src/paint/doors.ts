/** Drawing of doors: a bar across the track, whose form says what its colour says. */
import { type DeviceLook, signOfDevice } from "../shows";
import type { View } from "../view";
import type { DoorMark } from "../doors";
import { type Ctx, DEVICE_INK, font, INK, type Now, type Scene, text, widthOf } from "./ink";
import type { Labels } from "./labels";

/** Half the width of a doorway, mm. */
const WING = 750;

export const wingOf = (view: View): number => Math.max(13, WING * view.scale);

export function paintDoors(ctx: Ctx, view: View, scene: Scene, now: Now, labels: Labels): void {
  for (const mark of scene.doors) {
    const look = now.look(mark.id);
    const [px, py] = [view.px(mark.x), view.py(mark.y)];
    const wing = wingOf(view);
    const [w, h] = [Math.abs(Math.sin(mark.angle)) * wing + 6, Math.abs(Math.cos(mark.angle)) * wing + 6];
    labels.block({ x0: px - w, y0: py - h, x1: px + w, y1: py + h });
    paintBar(ctx, px, py, mark.angle, wing, look);
    if (now.picked?.id === mark.id) {
      ctx.strokeStyle = INK.picked;
      ctx.lineWidth = 2;
      ctx.strokeRect(px - w - 2, py - h - 2, w * 2 + 4, h * 2 + 4);
    }
  }
  if (view.scale < 0.012) return;
  for (const mark of scene.doors.filter((one) => one.named)) paintName(ctx, view, mark, now, labels);
}

/**
 * Closed: a whole bar. Open: its halves drawn back to the posts. Busy: the halves on their way, dotted between. Unknown: an
 * empty bar. Not heard: a dashed one. Error: a whole bar crossed out.
 */
function paintBar(ctx: Ctx, px: number, py: number, angle: number, wing: number, look: DeviceLook): void {
  const thick = Math.max(4, wing * 0.22);
  ctx.save();
  ctx.translate(px, py);
  ctx.rotate(angle);
  ctx.lineCap = "butt";
  ctx.strokeStyle = ctx.fillStyle = DEVICE_INK[look];
  ctx.lineWidth = 1.6;
  const bar = (from: number, to: number): void => ctx.fillRect(-thick / 2, from, thick, to - from);
  if (look === "open") {
    bar(-wing, -wing * 0.62);
    bar(wing * 0.62, wing);
  } else if (look === "busy") {
    bar(-wing, -wing * 0.35);
    bar(wing * 0.35, wing);
    ctx.setLineDash([2, 2]);
    line(ctx, 0, -wing * 0.35, 0, wing * 0.35);
  } else if (look === "closed" || look === "error") bar(-wing, wing);
  else {
    ctx.fillStyle = INK.ground;
    bar(-wing, wing);
    ctx.setLineDash(look === "silent" ? [3, 3] : []);
    ctx.strokeRect(-thick / 2, -wing, thick, wing * 2);
  }
  ctx.setLineDash([]);
  if (look === "error") {
    const s = thick * 1.3;
    ctx.strokeStyle = INK.picked;
    line(ctx, -s, -s, s, s);
    line(ctx, -s, s, s, -s);
  }
  ctx.fillStyle = INK.text;
  for (const end of [-wing, wing]) ctx.fillRect(-thick / 2 - 2, end - 1.5, thick + 4, 3);
  ctx.restore();
}

function line(ctx: Ctx, x0: number, y0: number, x1: number, y1: number): void {
  ctx.beginPath();
  ctx.moveTo(x0, y0);
  ctx.lineTo(x1, y1);
  ctx.stroke();
}

/** A door's name, with its sign, beside one of its posts. */
function paintName(ctx: Ctx, view: View, mark: DoorMark, now: Now, labels: Labels): void {
  const look = now.look(mark.id);
  const device = now.device(mark.id);
  const words = `${mark.id} ${signOfDevice(device, look)}`.trim();
  const letters = font(view.scale > 0.045 ? 12 : 10.5, 600);
  const width = widthOf(ctx, words, letters);
  const wing = wingOf(view);
  const [px, py] = [view.px(mark.x), view.py(mark.y)];
  const [w, h] = [Math.abs(Math.sin(mark.angle)) * wing, Math.abs(Math.cos(mark.angle)) * wing];
  const across = [{ x: px + w + 11 + width / 2, y: py + 4 }, { x: px - w - 11 - width / 2, y: py + 4 }];
  const along = [{ x: px, y: py - h - 11 }, { x: px, y: py + h + 20 }];
  const places = w > h ? [...across, ...along] : [...along, ...across];
  const place = places[labels.take(places, width)];
  if (place) text(ctx, words, place.x, place.y, DEVICE_INK[device?.alarm ? "error" : look], letters);
}
