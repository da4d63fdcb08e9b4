/** Finds a vehicle, station, carrier, job, device or barcode by its name, and shows it on the map. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { type Found, find } from "../find";
import { selected } from "../store";
import { t } from "../texts";

export function Finder({ go }: { go: (found: Found) => void }) {
  const letters = useSignal("");
  const which = useSignal(0);
  const box = useRef<HTMLInputElement>(null);
  useEffect(() => {
    const key = (event: KeyboardEvent): void => {
      if (event.key !== "/" || event.ctrlKey || event.target instanceof HTMLInputElement) return;
      event.preventDefault();
      box.current?.focus();
    };
    document.addEventListener("keydown", key);
    return () => document.removeEventListener("keydown", key);
  }, []);
  const list = find(letters.value);
  const choose = (found: Found | undefined): void => {
    if (!found) return;
    const pick = found.at ?? (found.kind === "barcode" ? null : { kind: found.kind, id: found.id });
    if (pick) selected.value = pick;
    go(found.at ? { kind: found.at.kind, id: found.at.id } : found);
    letters.value = "";
    box.current?.blur();
  };
  const key = (event: KeyboardEvent): void => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step) which.value = Math.min(Math.max(which.value + step, 0), list.length - 1);
    else if (event.key === "Enter") choose(list[which.value]);
    else if (event.key === "Escape") letters.value = "";
    else return;
    event.preventDefault();
  };
  return (
    <div class="finder">
      <input
        ref={box}
        role="combobox"
        aria-expanded={list.length > 0}
        aria-controls="found"
        aria-label={t("find")}
        placeholder={`${t("find")}  /`}
        autocomplete="off"
        value={letters.value}
        onInput={(event) => {
          letters.value = event.currentTarget.value;
          which.value = 0;
        }}
        onKeyDown={key}
      />
      {letters.value.trim() && (
        <ul id="found" role="listbox" aria-label={t("find")}>
          {list.map((found, i) => (
            <li
              key={`${found.kind} ${found.id}`}
              role="option"
              aria-selected={i === which.value}
              onPointerDown={(event) => {
                event.preventDefault();
                choose(found);
              }}
            >
              {found.id}
              <small>{found.at ? `${t("carrier")} · ${found.at.id}` : t(found.kind === "station" ? "at_station" : found.kind)}</small>
            </li>
          ))}
          {list.length === 0 && <li class="none">{t("nothing_found")}</li>}
        </ul>
      )}
    </div>
  );
}
