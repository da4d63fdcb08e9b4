/**
 * Where the order form is on a narrow screen: beside the map as everywhere; in another room its table needs the width, and the form
 * lies over it when somebody opens it. The style sheet shows these buttons where there is no room beside the table.
 */
import { effect, signal } from "@preact/signals";
import { room } from "../route";
import { selected } from "../store";
import { t } from "../texts";

const OPENER = "open-ordering";
export const ordering = signal(false);

/** Another room, or something that was chosen: the form has done its work. */
effect(() => {
  void room.value;
  void selected.value;
  ordering.value = false;
});

function close(): void {
  ordering.value = false;
  document.getElementById(OPENER)?.focus();
}

function open(): void {
  ordering.value = true;
  requestAnimationFrame(() => document.querySelector<HTMLElement>("#ordering select")?.focus());
}

export function OpenOrder() {
  if (room.value === "map" || selected.value) return null;
  return (
    <button type="button" id={OPENER} class="opens-order" aria-expanded={ordering.value} aria-controls="ordering" onClick={() => (ordering.value ? close() : open())}>
      {t("new_transfer")}
    </button>
  );
}

/** At the top of what lies over the table; Escape does the same from anywhere in it. */
export function CloseOrder() {
  if (!ordering.value) return null;
  return (
    <div class="closes-order">
      <button type="button" onClick={close}>
        {t("close")}
      </button>
    </div>
  );
}

document.addEventListener("keydown", (event) => {
  if (event.key === "Escape" && ordering.value && !event.defaultPrevented && !document.querySelector("dialog[open]")) close();
});
