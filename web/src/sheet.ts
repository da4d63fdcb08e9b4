/** A canvas larger than the map: shifted with the view while somebody moves it, and painted anew only when it has to be. */
import { View } from "./view";

/** After a zoom it is blurred for at most so long, ms. */
const BLURRED = 140;

export class Sheet {
  readonly ctx: CanvasRenderingContext2D;
  private readonly at = new View();
  private ratio = 1;
  private since = 0;

  /** `margin`: painted beyond each edge of the map, px. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly margin: number,
  ) {
    this.ctx = canvas.getContext("2d") as CanvasRenderingContext2D;
    canvas.style.transformOrigin = "0 0";
  }

  resize(width: number, height: number, ratio: number): void {
    const { margin } = this;
    const [w, h] = [width + 2 * margin, height + 2 * margin];
    this.ratio = ratio;
    this.canvas.width = Math.round(w * ratio);
    this.canvas.height = Math.round(h * ratio);
    Object.assign(this.canvas.style, { left: `${-margin}px`, top: `${-margin}px`, width: `${w}px`, height: `${h}px` });
    this.at.scale = 0;
  }

  /** Shift to where the view is. False: it does not show all of it, or not sharply any more. */
  follow(view: View, now: number): boolean {
    if (this.at.scale === 0) return false;
    const { margin } = this;
    const k = view.scale / this.at.scale;
    const [dx, dy] = [view.x + margin - k * this.at.x, view.y + margin - k * this.at.y];
    this.canvas.style.transform = k === 1 ? `translate(${dx}px, ${dy}px)` : `translate(${dx}px, ${dy}px) scale(${k})`;
    if (k === 1) this.since = now;
    const [left, top] = [dx - margin, dy - margin];
    const [right, bottom] = [left + k * (view.width + 2 * margin), top + k * (view.height + 2 * margin)];
    const whole = left <= 0 && top <= 0 && right >= view.width && bottom >= view.height;
    return whole && (k === 1 || now - this.since < BLURRED);
  }

  /** Whether it is shown larger or smaller than painted, and will have to be painted anew soon. */
  get blurred(): boolean {
    return this.canvas.style.transform.includes("scale");
  }

  /** An empty sheet for this view: paint it in the view that is returned. */
  begin(view: View, now: number): View {
    const { at, margin } = this;
    Object.assign(at, { scale: view.scale, x: view.x + margin, y: view.y + margin });
    Object.assign(at, { width: view.width + 2 * margin, height: view.height + 2 * margin });
    this.ctx.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.ctx.clearRect(0, 0, at.width, at.height);
    this.since = now;
    this.canvas.style.transform = "translate(0px, 0px)";
    return at;
  }
}
