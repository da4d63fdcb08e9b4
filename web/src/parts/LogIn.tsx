/** Asks who is there: name and password, or a machine's key. What stands on the page behind it stays as it was. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { logIn, me, useKey } from "../access";
import { t } from "../texts";
import { Told, useAsking } from "./asking";

export function LogIn() {
  const byKey = useSignal(false);
  const name = useSignal(me.value?.person ? (me.value.name ?? "") : "");
  const secret = useSignal("");
  const box = useRef<HTMLDialogElement>(null);
  const asking = useAsking();
  const again = me.value !== null && !me.value.open;
  useEffect(() => box.current?.showModal(), []);
  const enter = async (event: Event): Promise<void> => {
    event.preventDefault();
    const given = secret.value;
    const done = await asking.ask(() => (byKey.value ? useKey(given.trim()) : logIn(name.value.trim(), given)), "");
    if (!done) secret.value = "";
  };
  const other = (): void => {
    byKey.value = !byKey.value;
    secret.value = "";
    asking.error.value = null;
  };
  return (
    <dialog ref={box} aria-label={t("log_in")} onCancel={(event) => event.preventDefault()}>
      <form onSubmit={(event) => void enter(event)}>
        <h2>{t(again ? "log_in_again" : byKey.value ? "key_title" : "log_in_title")}</h2>
        {again && <p>{t("nothing_lost")}</p>}
        {!byKey.value && (
          <label>
            <span>{t("name")}</span>
            <input
              name="name"
              required
              maxLength={64}
              autocomplete="username"
              value={name.value}
              onInput={(event) => (name.value = event.currentTarget.value)}
            />
          </label>
        )}
        <label key={String(byKey.value)}>
          <span>{t(byKey.value ? "key_label" : "password")}</span>
          <input
            name={byKey.value ? "key" : "password"}
            type="password"
            required
            autocomplete={byKey.value ? "off" : "current-password"}
            value={secret.value}
            onInput={(event) => (secret.value = event.currentTarget.value)}
          />
        </label>
        {byKey.value && <p>{t("key_hint")}</p>}
        <Told asking={asking} />
        <div class="acts-row">
          <button type="submit" class="primary" disabled={asking.busy.value}>
            {t(byKey.value ? "key_use" : "log_in")}
          </button>
          <button type="button" class="text" onClick={other}>
            {t(byKey.value ? "use_password" : "use_a_key")}
          </button>
        </div>
      </form>
    </dialog>
  );
}
