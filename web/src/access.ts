/** Who is at the page and which calls they may make: the server says both, and when they have to say so again. */
import { computed, signal } from "@preact/signals";
import * as api from "./api";
import { said, t } from "./texts";

/** A row of the server's policy: method and path under /api/v1, as `GET /session/calls` names them. */
export type Call = `${"GET" | "POST" | "PUT" | "PATCH" | "DELETE"} /${string}`;

export interface Caller {
  /** Nobody has to say who they are; then all is allowed. */
  open: boolean;
  name: string | null;
  /** Logged in with a password; else it is a machine's key. */
  person: boolean;
  roles: string[];
}

interface Ruling {
  call: string;
  roles: string[];
  allowed: boolean;
}

interface Session {
  token: string;
  expires: string;
  until: string;
  name: string;
}

const KEPT = "hoistway.session";
/** What a tab and those that were made of it have in common: a name for the log-in. */
const FAMILY = "hoistway.family";
/** Looked so often whether the token is to be renewed, ms. */
const LOOK = 15_000;
/** A server that does not answer is asked again after so long, ms. */
const LATER = 2000;

export const me = signal<Caller | null>(null);
/** Whether somebody has to say who they are before the page can go on. */
export const asked = signal(false);
/** Rises whenever it becomes known who is there: what was refused before is read again. */
export const round = signal(0);
/** Why a button that was pressed does nothing; whether somebody else could press it. */
export const barred = signal<{ why: string; by: "role" | "state" } | null>(null);
const rulings = signal(new Map<string, Ruling>());

interface Kept {
  renew: number;
  expires: number;
  until: number;
}

export const session = signal<Kept | null>(kept());

function kept(): Kept | null {
  try {
    return JSON.parse(sessionStorage.getItem(KEPT) ?? "null") as Kept | null;
  } catch {
    return null;
  }
}

function keep(next: Kept | null): void {
  session.value = next;
  if (next) sessionStorage.setItem(KEPT, JSON.stringify(next));
  else sessionStorage.removeItem(KEPT);
}

/** Said to the tabs that were duplicated from this one, or it from them: a new token, or that they are logged out. */
type Word = { family: string; token: string; kept: Kept } | { family: string; token: null };
const others = new BroadcastChannel(KEPT);

const family = (): string => sessionStorage.getItem(FAMILY) ?? "";

function hear({ data }: MessageEvent<Word>): void {
  if (!family() || data.family !== family()) return;
  if (data.token === null) void leave();
  else {
    api.useKey(data.token);
    keep(data.kept);
  }
}

/** All roles there are: each may at least look. */
export const allRoles = computed(() => {
  const lists = [...rulings.value.values()].map(({ roles }) => roles);
  return lists.reduce((longest, roles) => (roles.length > longest.length ? roles : longest), []);
});

/** Roles in words, for people. */
export const inWords = (roles: string[]): string => roles.map((role) => said(`role_${role}`)).join(", ");

/** Why who is here may not make a call; "" where they may, or where the server is to say so itself. */
export function refusal(call: Call): string {
  const who = me.value;
  const ruling = rulings.value.get(call);
  if (!who || who.open || !ruling || ruling.allowed) return "";
  return t("needs_role", inWords(ruling.roles), who.name ?? "", inWords(who.roles) || t("none"));
}

/** Whether the people who work here are named by themselves: nobody logs in, or a machine's key speaks for somebody. */
export const namesItself = computed(() => me.value === null || me.value.open || !me.value.person);

/** Ask the server who this is and what they may. `anew`: somebody has just said who they are. */
async function learn(anew = false): Promise<void> {
  const [who, calls] = await Promise.all([api.get<Caller>("/session"), api.get<{ items: Ruling[] }>("/session/calls")]);
  const same = JSON.stringify(who) === JSON.stringify(me.value);
  if (same && !anew) return;
  rulings.value = new Map(calls.items.map((ruling) => [ruling.call, ruling]));
  me.value = who;
  barred.value = null;
  round.value++;
}

function take({ token, expires, until }: Session): void {
  const [now, end] = [api.serverNow(), Date.parse(expires)];
  const kept = { renew: now + (end - now) / 2, expires: end, until: Date.parse(until) };
  api.useKey(token);
  keep(kept);
  if (family()) others.postMessage({ family: family(), token, kept } satisfies Word);
}

/** Somebody has said who they are: what waited for that goes on. */
async function entered(): Promise<void> {
  await learn(true);
  asked.value = false;
  api.letGo();
}

/** Log in with a password. Raises Refused. */
export async function logIn(name: string, password: string): Promise<void> {
  const given = await api.post<Session>("/session", { name, password });
  sessionStorage.setItem(FAMILY, api.freshKey());
  take(given);
  await entered();
}

/** Use a machine's key. Raises Refused. */
export async function useKey(key: string): Promise<void> {
  const before = api.held();
  api.useKey(key);
  try {
    await entered();
  } catch (failure) {
    // Who was here before still is.
    api.useKey(before);
    throw failure;
  }
  keep(null);
  sessionStorage.setItem(FAMILY, api.freshKey());
}

/** Log out, here and in the tabs that were duplicated. */
export async function logOut(): Promise<void> {
  if (family()) others.postMessage({ family: family(), token: null } satisfies Word);
  await leave();
}

/** End the session, and begin with an empty page: nothing of what was shown stays. */
async function leave(): Promise<void> {
  if (me.value?.person) await api.call("DELETE", "/session").catch(() => undefined);
  forget();
  location.reload();
}

function forget(): void {
  api.useKey("");
  sessionStorage.removeItem(FAMILY);
  keep(null);
}

async function renew(): Promise<void> {
  const now = session.value;
  if (!now || asked.value || api.serverNow() < now.renew) return;
  // Once more only after a while, if the server does not answer now.
  keep({ ...now, renew: api.serverNow() + LOOK });
  try {
    take(await api.post<Session>("/session/renew"));
  } catch {
    /* A session that is over asks for a new log-in by itself. */
  }
}

/** Ask whenever the server wants to know; `go` begins, and goes on after each log-in; `gone`: it does not answer. */
export function begin(go: () => void, gone: () => void): void {
  api.onKeyWanted(() => (asked.value = true));
  // Roles may have changed since they were asked for.
  api.onForbidden(() => void learn().catch(() => undefined));
  others.addEventListener("message", hear);
  window.setInterval(() => void renew(), LOOK);
  if (session.value && session.value.expires < api.serverNow()) forget();
  if (!api.held()) api.holdBack();
  const first = async (): Promise<void> => {
    try {
      if (!api.held() && (await api.get<{ required: boolean }>("/session/required")).required) {
        asked.value = true;
        return;
      }
      api.letGo();
      await learn();
    } catch (error) {
      if (error instanceof api.Refused && error.status === 401) return;
      gone();
      window.setTimeout(() => void first(), LATER);
    }
  };
  void first();
  void renew();
  let before = round.value;
  round.subscribe((now) => {
    if (now !== before) go();
    before = now;
  });
}
