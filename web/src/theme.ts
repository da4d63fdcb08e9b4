/** Light or dark: the colours themselves are custom properties of the style sheet, which the map reads too. */
import { signal } from "@preact/signals";

export type Theme = "dark" | "light";

const KEPT = "hoistway.theme";
const kept = localStorage.getItem(KEPT);
const LIGHT = matchMedia("(prefers-color-scheme: light)");
export const theme = signal<Theme>(kept === "dark" || kept === "light" ? kept : LIGHT.matches ? "light" : "dark");

/** Show it, without choosing it for good. */
export function wear(next: Theme): void {
  document.documentElement.dataset["theme"] = next;
  theme.value = next;
}

export function choose(next: Theme): void {
  localStorage.setItem(KEPT, next);
  wear(next);
}

export function begin(): void {
  wear(theme.value);
  LIGHT.addEventListener("change", () => {
    if (!localStorage.getItem(KEPT)) wear(LIGHT.matches ? "light" : "dark");
  });
}
