/** A menu that is opened by its button closes when somebody presses elsewhere, or Escape in it: the button has the focus then. */
import type { Signal } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";

/** Give what the box with button and menu is to have: its ref, and what a key does in it. */
export function useClosed(open: Signal<boolean>): { ref: RefObject<HTMLDivElement>; onKeyDown: (event: KeyboardEvent) => void } {
  const ref = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!open.value) return undefined;
    const press = (event: Event): void => {
      if (!ref.current?.contains(event.target as Node)) open.value = false;
    };
    document.addEventListener("pointerdown", press);
    return () => document.removeEventListener("pointerdown", press);
  }, [open.value]);
  const onKeyDown = (event: KeyboardEvent): void => {
    if (event.key !== "Escape" || !open.value) return;
    open.value = false;
    ref.current?.querySelector("button")?.focus();
  };
  return { ref: ref as RefObject<HTMLDivElement>, onKeyDown };
}
