/** REST: who asks, with which key, and what the server says when it does not want to. */

/** A refusal of the server (RFC 9457), or of the network. */
export class Refused extends Error {
  constructor(
    readonly status: number,
    message: string,
    readonly remedy = "",
    readonly field = "",
    /** Each thing that is wrong, where there are several. */
    readonly errors: Record<string, unknown>[] = [],
  ) {
    super(message);
  }
}

const KEY = "hoistway.key";
const ACTOR = "hoistway.actor";
const TIMEOUT = 35_000;

let key = sessionStorage.getItem(KEY) ?? "";
let wantsKey: () => void = () => undefined;
let forbidden: () => void = () => undefined;
/** Server's clock minus ours, ms, from the Date header (whole seconds). */
let skew = 0;

export function onKeyWanted(call: () => void): void {
  wantsKey = call;
}

/** Whoever is here may not do what was asked for. */
export function onForbidden(call: () => void): void {
  forbidden = call;
}

let may: Promise<void> = Promise.resolve();
let goOn: () => void = () => undefined;

/** Nothing is asked for but who is there, until it is known that somebody may: `letGo`. */
export function holdBack(): void {
  may = new Promise((done) => (goOn = done));
}

export function letGo(): void {
  goOn();
}

/** The key or token that is kept; "": none. */
export function held(): string {
  return key;
}

export function useKey(given: string): void {
  key = given;
  sessionStorage.setItem(KEY, given);
}

export function actor(): string {
  return localStorage.getItem(ACTOR) ?? "";
}

export function nameActor(name: string): void {
  localStorage.setItem(ACTOR, name.trim());
}

/** The server's time, ms. */
export function serverNow(): number {
  return Date.now() + skew;
}

/** A header carries bytes; the server reads them as UTF-8. */
export function headerText(text: string): string {
  return String.fromCharCode(...new TextEncoder().encode(text));
}

let notNow = (): string => "";

/** Nothing may be asked of the plant while this says why not. */
export function forbidWhile(why: () => string): void {
  notNow = why;
}

/** Who is there may be said at any time, and the stream goes on. */
const ALWAYS = /^\/(session|live)(\/|$)/;
const SESSION = /^\/session(\/|$)/;

export async function call<T>(method: string, path: string, body?: unknown, extra: Record<string, string> = {}): Promise<T> {
  const why = method === "GET" || ALWAYS.test(path) ? "" : notNow();
  if (why) throw new Refused(0, why);
  if (!SESSION.test(path)) await may;
  // What came of a request is said in English and told by the page, which has names of its own for what would help.
  const language = method === "GET" ? document.documentElement.lang || "en" : "en";
  const headers: Record<string, string> = { Accept: "application/json", "Accept-Language": language, ...extra };
  if (key) headers["Authorization"] = `Bearer ${headerText(key)}`;
  if (method !== "GET" && actor()) headers["X-Actor"] = headerText(actor());
  if (body !== undefined) headers["Content-Type"] = "application/json";
  const init: RequestInit = { method, headers, signal: AbortSignal.timeout(TIMEOUT) };
  if (body !== undefined) init.body = JSON.stringify(body);
  let response: Response;
  try {
    response = await fetch(`/api/v1${path}`, init);
  } catch {
    throw new Refused(0, "The server does not answer.");
  }
  const date = Date.parse(response.headers.get("date") ?? "");
  if (Math.abs(date + 500 - serverNow()) > 1500) skew = date + 500 - Date.now();
  if (response.ok) return (response.status === 204 ? undefined : await response.json()) as T;
  throw await refusal(response);
}

async function refusal(response: Response): Promise<Refused> {
  if (response.status === 401) wantsKey();
  if (response.status === 403) forbidden();
  const problem = (await response.json().catch(() => ({}))) as Record<string, unknown>;
  const text = (name: string): string => (typeof problem[name] === "string" ? (problem[name] as string) : "");
  return new Refused(
    response.status,
    text("detail") || text("title") || `${response.status} ${response.statusText}`,
    text("remedy"),
    text("field"),
    Array.isArray(problem["errors"]) ? (problem["errors"] as Record<string, unknown>[]) : [],
  );
}

export const get = <T>(path: string): Promise<T> => call<T>("GET", path);
export const post = <T>(path: string, body?: unknown, extra?: Record<string, string>): Promise<T> =>
  call<T>("POST", path, body, extra);

async function fetched(path: string): Promise<Response> {
  await may;
  const headers: Record<string, string> = key ? { Authorization: `Bearer ${headerText(key)}` } : {};
  const response = await fetch(`/api/v1${path}`, { headers, signal: AbortSignal.timeout(TIMEOUT) }).catch(() => {
    throw new Refused(0, "The server does not answer.");
  });
  if (!response.ok) throw await refusal(response);
  return response;
}

export async function bytes(path: string): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await (await fetched(path)).arrayBuffer());
}

/** Send a file as it is. */
export async function upload<T>(path: string, text: string, kind: string): Promise<T> {
  const headers: Record<string, string> = { Accept: "application/json", "Accept-Language": document.documentElement.lang || "en", "Content-Type": kind };
  if (key) headers["Authorization"] = `Bearer ${headerText(key)}`;
  if (actor()) headers["X-Actor"] = headerText(actor());
  await may;
  const response = await fetch(`/api/v1${path}`, { method: "POST", headers, body: text, signal: AbortSignal.timeout(TIMEOUT) });
  if (!response.ok) throw await refusal(response);
  return (await response.json()) as T;
}

/** Let the browser save what a path gives. A link could not carry the access key. */
export async function download(path: string, name: string): Promise<void> {
  const response = await fetched(path);
  const link = document.createElement("a");
  link.href = URL.createObjectURL(await response.blob());
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

export async function alive(): Promise<boolean> {
  try {
    return (await fetch("/healthz", { signal: AbortSignal.timeout(3000), cache: "no-store" })).ok;
  } catch {
    return false;
  }
}

/** A name for an order that may be sent again. randomUUID exists on secure pages only. */
export function freshKey(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(12));
  return `page-${Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("")}`;
}
