/** Something that is shown once and never again: a key, a secret; it is copied and put away. */
import { type Signal, useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { t } from "../texts";

export function Once({ label, value }: { label: string; value: Signal<string> }) {
  const box = useRef<HTMLInputElement>(null);
  const copied = useSignal(false);
  if (!value.value) return null;
  const copy = async (): Promise<void> => {
    box.current?.select();
    try {
      await navigator.clipboard.writeText(value.value);
    } catch {
      // There is no clipboard without TLS, but on this machine.
      document.execCommand("copy");
    }
    copied.value = true;
  };
  return (
    <div class="note waits stack" data-once>
      <b>{label}</b>
      <span>{t("shown_once")}</span>
      <input ref={box} readOnly class="hex" aria-label={label} value={value.value} onFocus={(event) => event.currentTarget.select()} />
      <div class="acts-row">
        <button type="button" class="primary" onClick={() => void copy()}>
          {t(copied.value ? "copied" : "copy")}
        </button>
        <button
          type="button"
          onClick={() => {
            value.value = "";
            copied.value = false;
          }}
        >
          {t("put_away")}
        </button>
      </div>
    </div>
  );
}
