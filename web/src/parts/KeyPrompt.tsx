/** Asks for the access key; it stays in this tab. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { useKey } from "../api";
import { keyWanted, start } from "../store";
import { t } from "../texts";

export function KeyPrompt() {
  const key = useSignal("");
  const box = useRef<HTMLDialogElement>(null);
  useEffect(() => box.current?.showModal(), []);
  const use = (event: Event): void => {
    event.preventDefault();
    useKey(key.value.trim());
    keyWanted.value = false;
    void start();
  };
  return (
    <dialog ref={box} onCancel={(event) => event.preventDefault()}>
      <form onSubmit={use}>
        <h2>{t("key_title")}</h2>
        <label>
          <span>{t("key_label")}</span>
          <input
            type="password"
            required
            autocomplete="off"
            value={key.value}
            onInput={(event) => (key.value = event.currentTarget.value)}
          />
        </label>
        <p>{t("key_hint")}</p>
        <button type="submit" class="primary">
          {t("key_use")}
        </button>
      </form>
    </dialog>
  );
}
