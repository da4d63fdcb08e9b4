/** Pan and zoom: from mm of the plan to pixels and back. Pure. */

export interface Box {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

const FURTHEST_IN = 0.4;

export class View {
  scale = 0.03;
  x = 0;
  y = 0;
  /** Until somebody moves the view, it keeps showing everything. */
  fitted = true;
  width = 1;
  height = 1;

  fit(box: Box, margin: { top: number; side: number; bottom: number }): void {
    const [w, h] = [Math.max(box.x1 - box.x0, 1000), Math.max(box.y1 - box.y0, 1000)];
    const [roomX, roomY] = [this.width - 2 * margin.side, this.height - margin.top - margin.bottom];
    this.scale = Math.max(1e-5, Math.min(roomX / w, roomY / h, 0.2));
    this.x = margin.side + (roomX - w * this.scale) / 2 - box.x0 * this.scale;
    this.y = margin.top + (roomY - h * this.scale) / 2 - box.y0 * this.scale;
    this.fitted = true;
  }

  zoom(factor: number, px: number, py: number): void {
    const next = Math.min(FURTHEST_IN, Math.max(0.0005, this.scale * factor));
    const [mx, my] = [(px - this.x) / this.scale, (py - this.y) / this.scale];
    this.scale = next;
    this.x = px - mx * next;
    this.y = py - my * next;
    this.fitted = false;
  }

  pan(dx: number, dy: number): void {
    this.x += dx;
    this.y += dy;
    this.fitted = false;
  }

  centre(mx: number, my: number): void {
    this.x = this.width / 2 - mx * this.scale;
    this.y = this.height / 2 - my * this.scale;
    this.fitted = false;
  }

  px(mx: number): number {
    return mx * this.scale + this.x;
  }

  py(my: number): number {
    return my * this.scale + this.y;
  }

  /** Whether anything of a box in mm may be seen, or lies so many px beside the edge. */
  sees(box: Box, beside = 40): boolean {
    return (
      this.px(box.x1) > -beside &&
      this.py(box.y1) > -beside &&
      this.px(box.x0) < this.width + beside &&
      this.py(box.y0) < this.height + beside
    );
  }
}
