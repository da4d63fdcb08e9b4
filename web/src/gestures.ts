/** How people move the map and choose on it: pointer, wheel and keys. */
import { choosing } from "./closed";
import { following } from "./layers";
import type { Painter } from "./painter";
import { type Selection, selected } from "./store";

/** Listens on the map; `show` is told what lies under the pointer, and where that is. Returns how to stop. */
export function listenTo(
  touched: HTMLElement,
  paint: Painter,
  show: (hit: Selection, x: number, y: number) => void,
): () => void {
  const ends = new AbortController();
  const { signal } = ends;
  let from: { x: number; y: number; moved: boolean } | null = null;
  touched.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      paint.view.zoom(Math.exp(-event.deltaY * 0.0015), event.offsetX, event.offsetY);
      paint.move();
    },
    { passive: false, signal },
  );
  touched.addEventListener(
    "pointerdown",
    (event) => {
      from = { x: event.offsetX, y: event.offsetY, moved: false };
      touched.setPointerCapture(event.pointerId);
    },
    { signal },
  );
  touched.addEventListener(
    "pointermove",
    (event) => {
      const [x, y] = [event.offsetX, event.offsetY];
      if (from) {
        if (!from.moved && Math.hypot(x - from.x, y - from.y) < 4) return;
        paint.view.pan(x - from.x, y - from.y);
        from = { x, y, moved: true };
        show(null, 0, 0);
        following.value = false;
        paint.move();
        return;
      }
      paint.hovered = paint.at(x, y);
      touched.style.cursor = paint.hovered ? "pointer" : "grab";
      show(paint.hovered, Math.min(x + 14, paint.view.width - 250), Math.min(y + 14, paint.view.height - 90));
      paint.wake();
    },
    { signal },
  );
  touched.addEventListener(
    "pointerup",
    (event) => {
      if (from && !from.moved) click(paint, event.offsetX, event.offsetY);
      from = null;
    },
    { signal },
  );
  touched.addEventListener(
    "pointerleave",
    () => {
      paint.hovered = null;
      show(null, 0, 0);
      paint.wake();
    },
    { signal },
  );
  touched.addEventListener("keydown", (event) => void (keyed(event.key, paint) && event.preventDefault()), { signal });
  return () => ends.abort();
}

/** Choose what is there; while track is being chosen, the barcode. */
function click(paint: Painter, x: number, y: number): void {
  const barcode = choosing.value ? paint.barcodeAt(x, y) : null;
  if (barcode !== null) choosing.value?.(barcode);
  else selected.value = paint.at(x, y);
}

function keyed(key: string, paint: Painter): boolean {
  const { view } = paint;
  const step = 60;
  const moves: Record<string, () => void> = {
    ArrowLeft: () => view.pan(step, 0),
    ArrowRight: () => view.pan(-step, 0),
    ArrowUp: () => view.pan(0, step),
    ArrowDown: () => view.pan(0, -step),
    "+": () => view.zoom(1.25, view.width / 2, view.height / 2),
    "-": () => view.zoom(0.8, view.width / 2, view.height / 2),
    "0": () => paint.fit(),
    Escape: () => (selected.value = null),
    f: () => (following.value = !following.value),
  };
  const move = moves[key];
  move?.();
  if (move) paint.move();
  return move !== undefined;
}
