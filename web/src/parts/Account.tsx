/** Who is here, with which roles; the password, and the way out. Where nobody logs in, only the name that they give themselves. */
import { useSignal } from "@preact/signals";
import { asked, inWords, logOut, me, namesItself, session } from "../access";
import { actor, call, nameActor } from "../api";
import { clock } from "../shows";
import { t } from "../texts";
import { Field, Told, useAsking } from "./asking";
import { Button } from "./Button";
import { useClosed } from "./menu";
import { Fact } from "./Panel";

export function Account() {
  const who = me.value;
  return (
    <>
      {namesItself.value && <Actor />}
      {who && !who.open && <Menu name={who.name ?? ""} roles={who.roles} person={who.person} />}
    </>
  );
}

function Actor() {
  const name = useSignal(actor());
  return (
    <span class="actor">
      <input
        value={name.value}
        maxLength={64}
        aria-label={t("your_name")}
        autocomplete="name"
        title={t("name_hint")}
        placeholder={t("your_name")}
        onInput={(event) => {
          name.value = event.currentTarget.value;
          nameActor(name.value);
        }}
      />
    </span>
  );
}

function Menu({ name, roles, person }: { name: string; roles: string[]; person: boolean }) {
  const open = useSignal(false);
  const box = useClosed(open);
  return (
    <div {...box} class="layers master account">
      <button type="button" aria-expanded={open.value} title={inWords(roles)} onClick={() => (open.value = !open.value)}>
        <b>{name}</b> <small>{inWords(roles)}</small>
      </button>
      {open.value && (
        <div role="group" aria-label={t("account")}>
          <dl class="facts">
            <Fact name={t("name")}>{name}</Fact>
            <Fact name={t("roles")}>{inWords(roles) || t("none")}</Fact>
            {person && session.value && <Fact name={t("good_until")}>{clock(new Date(session.value.until).toISOString())}</Fact>}
            {!person && <Fact name={t("kind")}>{t("machine_key")}</Fact>}
          </dl>
          {person && <Password />}
          <div class="acts-row">
            <button type="button" onClick={() => (asked.value = true)}>
              {t("log_in_as_other")}
            </button>
            <button type="button" onClick={() => void logOut()}>
              {t("log_out")}
            </button>
          </div>
        </div>
      )}
    </div>
  );
}

function Password() {
  const old = useSignal("");
  const next = useSignal("");
  const asking = useAsking();
  const send = async (event: Event): Promise<void> => {
    event.preventDefault();
    const body = { old: old.value, new: next.value };
    if (await asking.ask(() => call("PUT", "/session/password", body), t("password_changed"))) old.value = next.value = "";
  };
  return (
    <details>
      <summary>{t("change_password")}</summary>
      <form class="stack" onSubmit={(event) => void send(event)}>
        <Field label={t("old_password")} name="old" type="password" value={old} required />
        <Field label={t("new_password")} name="new" type="password" value={next} hint={t("password_rule")} required />
        <div class="acts-row">
          <Button needs="PUT /session/password" type="submit" disabled={asking.busy.value}>
            {t("change_password")}
          </Button>
        </div>
        <Told asking={asking} />
      </form>
    </details>
  );
}
