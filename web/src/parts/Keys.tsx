/** The keys that the map takes. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { inPast } from "../store";
import { t } from "../texts";

const KEYS = [
  ["/", "key_find"],
  ["← ↑ → ↓", "key_pan"],
  ["+ −", "key_zoom"],
  ["0", "key_fit"],
  ["F", "key_follow"],
  ["Esc", "key_none"],
] as const;
const PAST_KEYS = [
  ["K", "play"],
  [",", "event_before"],
  [".", "event_next"],
] as const;

export function Keys() {
  const open = useSignal(false);
  return (
    <>
      <button type="button" aria-label={t("keys")} title={t("keys")} onClick={() => (open.value = true)}>
        ?
      </button>
      {open.value && <List close={() => (open.value = false)} />}
    </>
  );
}

function List({ close }: { close: () => void }) {
  const box = useRef<HTMLDialogElement>(null);
  useEffect(() => box.current?.showModal(), []);
  return (
    <dialog ref={box} aria-label={t("keys")} onClose={close}>
      <form method="dialog">
        <h2>{t("keys")}</h2>
        <dl class="keys">
          {KEYS.map(([key, word]) => (
            <div key={key}>
              <dt>
                <kbd>{key}</kbd>
              </dt>
              <dd>{t(word)}</dd>
            </div>
          ))}
        </dl>
        {inPast.value && (
          <>
            <h2>{t("keys_past")}</h2>
            <dl class="keys">
              {PAST_KEYS.map(([key, word]) => (
                <div key={key}>
                  <dt>
                    <kbd>{key}</kbd>
                  </dt>
                  <dd>{t(word)}</dd>
                </div>
              ))}
            </dl>
          </>
        )}
        <button type="submit">{t("close")}</button>
      </form>
    </dialog>
  );
}
