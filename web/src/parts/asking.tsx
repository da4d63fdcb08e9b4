/** Asking the server for something, and telling what came of it. */
import { type Signal, useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { round } from "../access";
import { get } from "../api";
import { connections } from "../store";
import { language, t } from "../texts";
import { Problem } from "./Problem";

export interface Asking {
  error: Signal<unknown>;
  done: Signal<string>;
  busy: Signal<boolean>;
  /** Ask; true if it was granted. */
  ask: (what: () => Promise<unknown>, words?: string) => Promise<boolean>;
}

export function useAsking(): Asking {
  const error = useSignal<unknown>(null);
  const done = useSignal("");
  const busy = useSignal(false);
  const ask = async (what: () => Promise<unknown>, words: string = t("taken")): Promise<boolean> => {
    error.value = null;
    done.value = "";
    busy.value = true;
    try {
      await what();
      done.value = words;
      return true;
    } catch (failure) {
      error.value = failure;
      return false;
    } finally {
      busy.value = false;
    }
  };
  return { error, done, busy, ask };
}

/** What came of it: a refusal with what helps, or that it is done. */
export function Told({ asking }: { asking: Asking }) {
  return (
    <>
      <Problem error={asking.error.value} />
      {asking.done.value && (
        <span class="done" role="status">
          {asking.done.value}
        </span>
      )}
    </>
  );
}

/** What a path gives, read again whenever one of these changes, or the server is back; the last answer stays until the next. */
export function useRead<T>(path: string | null, ...again: unknown[]): { value: T | null; error: unknown } {
  const value = useSignal<T | null>(null);
  const error = useSignal<unknown>(null);
  useEffect(() => {
    let here = true;
    if (path !== null) {
      get<T>(path).then(
        (found) => here && ((value.value = found), (error.value = null)),
        (failure: unknown) => here && (error.value = failure),
      );
    }
    return () => {
      here = false;
    };
  }, [path, language.value, round.value, connections.value, ...again]);
  return { value: value.value, error: error.value };
}

/** A labelled text or number to be written. */
export function Field(props: {
  label: string;
  value: Signal<string>;
  name?: string;
  type?: "text" | "number" | "password" | "search" | "datetime-local";
  list?: string;
  required?: boolean;
  min?: number;
  max?: number;
  step?: string;
  wide?: boolean;
  hint?: string;
}) {
  const { label, value, wide, hint, list, ...rest } = props;
  return (
    <label class={wide ? "wide" : ""}>
      <span>{label}</span>
      <input
        {...({ ...rest, ...(list ? { list } : {}) } as object)}
        placeholder={hint ?? ""}
        autocomplete="off"
        value={value.value}
        onInput={(event) => (value.value = event.currentTarget.value)}
      />
    </label>
  );
}

/** A labelled choice. */
export function Choice<T extends string>(props: { label: string; value: Signal<T>; of: readonly (readonly [T, string])[]; wide?: boolean }) {
  return (
    <label class={props.wide ? "wide" : ""}>
      <span>{props.label}</span>
      <select value={props.value.value} onChange={(event) => (props.value.value = event.currentTarget.value as T)}>
        {props.of.map(([value, words]) => (
          <option key={value} value={value}>
            {words}
          </option>
        ))}
      </select>
    </label>
  );
}
