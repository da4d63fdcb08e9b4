/** Users and keys: who may log in, which machines may call, with which roles; for administrators. */
import { type Signal, useSignal } from "@preact/signals";
import { allRoles, inWords, refusal } from "../access";
import { call, post } from "../api";
import { moment } from "../shows";
import { said, t } from "../texts";
import { Field, Told, useAsking, useRead } from "./asking";
import { Button } from "./Button";
import { Once } from "./Once";
import { Sure } from "./Sure";
import { Table } from "./Table";

interface User {
  name: string;
  roles: string[];
  created: string;
  created_by: string;
  disabled: boolean;
  logged_in: string | null;
}

interface Key {
  name: string;
  roles: string[];
  created: string;
  created_by: string;
  expires: string | null;
  used: string | null;
  state: string;
}

export function Staff() {
  const tab = useSignal<"users" | "keys">("users");
  const why = refusal("GET /users");
  return (
    <section class="room" aria-label={t("access")}>
      <div class="head">
        <h2>{t("access")}</h2>
        <span class="tabs">
          {(["users", "keys"] as const).map((name) => (
            <button type="button" key={name} aria-pressed={tab.value === name} onClick={() => (tab.value = name)}>
              {t(name === "users" ? "users" : "machine_keys")}
            </button>
          ))}
        </span>
      </div>
      {why ? <p class="nothing">{why}</p> : tab.value === "users" ? <Users /> : <Keys />}
    </section>
  );
}

function Roles({ value }: { value: Signal<string[]> }) {
  const turn = (role: string, on: boolean): void => {
    value.value = allRoles.value.filter((one) => (one === role ? on : value.value.includes(one)));
  };
  return (
    <fieldset class="roles">
      <legend>{t("roles")}</legend>
      {allRoles.value.map((role) => (
        <label key={role}>
          <input type="checkbox" checked={value.value.includes(role)} onChange={(event) => turn(role, event.currentTarget.checked)} />{" "}
          {said(`role_${role}`)}
        </label>
      ))}
    </fieldset>
  );
}

function Users() {
  const again = useSignal(0);
  const chosen = useSignal<string | null>(null);
  const { value } = useRead<{ items: User[] }>("/users", again.value);
  const user = value?.items.find(({ name }) => name === chosen.value);
  return (
    <div class="split">
      <Table
        label={t("users")}
        rows={value?.items}
        keyOf={(row) => row.name}
        pick={(row) => (chosen.value = row.name)}
        chosen={chosen.value}
        none={t("no_users")}
        columns={[
          {
            name: t("name"),
            by: (row) => row.name,
            of: (row) => (
              <button type="button" class="text" onClick={() => (chosen.value = row.name)}>
                {row.name}
              </button>
            ),
          },
          { name: t("roles"), by: (row) => row.roles.join(), of: (row) => inWords(row.roles) },
          { name: t("state"), by: (row) => Number(row.disabled), of: (row) => <span class={row.disabled ? "bad" : "good"}>{t(row.disabled ? "disabled" : "enabled")}</span> },
          { name: t("logged_in"), by: (row) => row.logged_in, of: (row) => (row.logged_in ? moment(row.logged_in) : t("never")) },
          { name: t("added"), by: (row) => row.created, of: (row) => `${moment(row.created)} · ${row.created_by}` },
        ]}
      />
      <div>
        {user && <Change key={user.name} user={user} after={() => again.value++} />}
        <Add after={() => again.value++} />
      </div>
    </div>
  );
}

function Change({ user, after }: { user: User; after: () => void }) {
  const roles = useSignal(user.roles);
  const password = useSignal("");
  const asking = useAsking();
  const path = `/users/${encodeURIComponent(user.name)}`;
  const change = async (body: object, words: string): Promise<void> => {
    if (await asking.ask(() => call("PATCH", path, body), words)) {
      password.value = "";
      after();
    }
  };
  const same = roles.value.join() === user.roles.join();
  return (
    <section class="stack padded" data-user={user.name} aria-label={user.name}>
      <h2 class="sub">{user.name}</h2>
      <Roles value={roles} />
      <div class="acts-row">
        <Sure needs="PATCH /users/{user}" label={t("change_roles")} disabled={same || roles.value.length === 0} does={() => void change({ roles: roles.value }, t("taken"))} />
        <Sure
          needs="PATCH /users/{user}"
          label={t(user.disabled ? "enable" : "disable")}
          does={() => void change({ disabled: !user.disabled }, t("taken"))}
        />
      </div>
      <div class="fields">
        <Field label={t("new_password")} name="password" value={password} hint={t("password_rule")} />
        <div class="acts-row">
          <Sure
            needs="PATCH /users/{user}"
            label={t("reset_password")}
            disabled={!password.value}
            does={() => void change({ password: password.value }, t("password_reset", user.name))}
          />
        </div>
      </div>
      <Told asking={asking} />
    </section>
  );
}

function Add({ after }: { after: () => void }) {
  const [name, password] = [useSignal(""), useSignal("")];
  const roles = useSignal<string[]>([]);
  const asking = useAsking();
  const send = async (event: Event): Promise<void> => {
    event.preventDefault();
    const body = { name: name.value.trim(), roles: roles.value, password: password.value };
    if (!(await asking.ask(() => post("/users", body), t("user_added", body.name)))) return;
    name.value = password.value = "";
    roles.value = [];
    after();
  };
  return (
    <form class="stack padded" aria-label={t("add_user")} onSubmit={(event) => void send(event)}>
      <h2 class="sub">{t("add_user")}</h2>
      <div class="fields">
        <Field label={t("name")} name="name" value={name} required />
        <Field label={t("password")} name="password" value={password} hint={t("password_rule")} required />
      </div>
      <Roles value={roles} />
      <div class="acts-row">
        <Button needs="POST /users" type="submit" disabled={roles.value.length === 0 || asking.busy.value}>
          {t("add_user")}
        </Button>
      </div>
      <Told asking={asking} />
    </form>
  );
}

function Keys() {
  const again = useSignal(0);
  const { value } = useRead<{ items: Key[] }>("/keys", again.value);
  const asking = useAsking();
  const revoke = async (name: string): Promise<void> => {
    await asking.ask(() => call("DELETE", `/keys/${encodeURIComponent(name)}`), t("key_revoked", name));
    again.value++;
  };
  return (
    <div class="split">
      <div>
        <Told asking={asking} />
        <Table
          label={t("machine_keys")}
          rows={value?.items}
          keyOf={(row) => row.name}
          none={t("no_keys")}
          columns={[
            { name: t("name"), by: (row) => row.name, of: (row) => row.name },
            { name: t("roles"), by: (row) => row.roles.join(), of: (row) => inWords(row.roles) },
            { name: t("state"), by: (row) => row.state, of: (row) => <span class={row.state === "active" ? "good" : "bad"}>{said(row.state === "revoked" ? "key_revoked_state" : `key_${row.state}`)}</span> },
            { name: t("expires"), by: (row) => row.expires, of: (row) => (row.expires ? moment(row.expires) : t("never")) },
            { name: t("last_used"), by: (row) => row.used, of: (row) => (row.used ? moment(row.used) : t("never")) },
            { name: t("added"), by: (row) => row.created, of: (row) => `${moment(row.created)} · ${row.created_by}` },
            {
              name: "",
              of: (row) => row.state === "active" && <Sure needs="DELETE /keys/{key}" label={t("revoke")} does={() => void revoke(row.name)} />,
            },
          ]}
        />
      </div>
      <Issue after={() => again.value++} />
    </div>
  );
}

function Issue({ after }: { after: () => void }) {
  const [name, days] = [useSignal(""), useSignal("365")];
  const roles = useSignal<string[]>([]);
  const made = useSignal("");
  const asking = useAsking();
  const send = async (event: Event): Promise<void> => {
    event.preventDefault();
    const body = { name: name.value.trim(), roles: roles.value, ...(days.value ? { days: Number(days.value) } : {}) };
    const done = await asking.ask(async () => {
      made.value = (await post<{ key: string }>("/keys", body)).key;
    }, "");
    if (!done) return;
    name.value = "";
    roles.value = [];
    after();
  };
  return (
    <form class="stack padded" aria-label={t("issue_key")} onSubmit={(event) => void send(event)}>
      <h2 class="sub">{t("issue_key")}</h2>
      <div class="fields">
        <Field label={t("name")} name="name" value={name} required />
        <Field label={t("days_good")} name="days" type="number" min={1} max={3660} value={days} hint={t("until_revoked")} />
      </div>
      <Roles value={roles} />
      <div class="acts-row">
        <Button needs="POST /keys" type="submit" disabled={roles.value.length === 0 || asking.busy.value}>
          {t("issue_key")}
        </Button>
      </div>
      <Told asking={asking} />
      <Once label={t("new_key")} value={made} />
    </form>
  );
}
