/** Parameters of a drive watched live: polled by the server as long as somebody looks, and drawn over the last minutes. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { refusal } from "../access";
import { call, get, serverNow } from "../api";
import { t, tell } from "../texts";
import type { Parameter } from "../types";
import { useRead } from "./asking";
import { Button } from "./Button";
import { LiveChart } from "./LiveChart";
import { Problem } from "./Problem";

/** Asked so often, ms; the server is told again in time that somebody still looks, s. */
const EVERY = 500;
const GOOD_FOR = 20;
const AGAIN = 8;
/** So much is shown, s, and at most so many lines. */
const SPAN = 180;
const MOST = 6;

interface Past {
  times: number[];
  values: Record<string, (number | null)[]>;
}

/** One name for each page, so that two people may watch the same drive. */
const NAME = `page-${Math.random().toString(36).slice(2, 10)}`;

export function DriveWatch({ path }: { path: string }) {
  const chosen = useSignal<string[]>([]);
  const on = useSignal(false);
  const past = useSignal<Past>({ times: [], values: {} });
  const error = useSignal<unknown>(null);
  const { value } = useRead<{ items: Parameter[] }>(`${path}/parameters`);
  const known = value?.items.filter(({ named, raw }) => named || raw !== null) ?? [];
  const numbers = chosen.value.join();
  const watch = `${path}/watches/${NAME}`;

  useEffect(() => {
    if (!on.value || !numbers) return undefined;
    let here = true;
    const fail = (failure: unknown): void => {
      error.value = failure;
      on.value = false;
    };
    const tell = (): void => void call("PUT", watch, { parameters: numbers.split(","), seconds: GOOD_FOR }).catch(fail);
    const look = async (): Promise<void> => {
      try {
        const { items } = await get<{ items: Parameter[] }>(`${path}/parameters`);
        if (here) past.value = grown(past.value, numbers.split(","), items);
      } catch (failure) {
        if (here) fail(failure);
      }
    };
    error.value = null;
    past.value = { times: [], values: {} };
    tell();
    const timers = [window.setInterval(tell, AGAIN * 1000), window.setInterval(() => void look(), EVERY)];
    return () => {
      here = false;
      timers.forEach(window.clearInterval);
      void call("DELETE", watch).catch(() => undefined);
    };
  }, [path, numbers, on.value]);

  const turn = (number: string, wanted: boolean): void => {
    chosen.value = known.map((one) => one.number).filter((one) => (one === number ? wanted : chosen.value.includes(one)));
  };
  const lines = chosen.value.flatMap((number) => {
    const parameter = known.find((one) => one.number === number);
    return parameter ? [{ label: tell(parameter.name) || number, unit: parameter.unit, values: past.value.values[number] ?? [] }] : [];
  });
  return (
    <details class="part acts">
      <summary>{t("watch")}</summary>
      <div class="stack" data-watch>
        <fieldset class="roles watched">
          <legend>{t("parameters")}</legend>
          {known.map(({ number, name }) => (
            <label key={number}>
              <input
                type="checkbox"
                checked={chosen.value.includes(number)}
                disabled={!chosen.value.includes(number) && chosen.value.length >= MOST}
                onChange={(event) => turn(number, event.currentTarget.checked)}
              />{" "}
              {number} {tell(name)}
            </label>
          ))}
          {known.length === 0 && <span class="calm">{t("no_parameters")}</span>}
        </fieldset>
        <div class="acts-row">
          <Button needs="PUT /drives/{drive}/watches/{watch}" aria-pressed={on.value} disabled={chosen.value.length === 0} onClick={() => (on.value = !on.value)}>
            {t(on.value ? "watch_end" : "watch_begin")}
          </Button>
          {refusal("PUT /drives/{drive}/watches/{watch}") === "" && <small class="calm">{t("watch_hint", MOST)}</small>}
        </div>
        <Problem error={error.value} />
        {past.value.times.length > 0 && <LiveChart label={t("watch")} times={past.value.times} lines={lines} />}
      </div>
    </details>
  );
}

/** With one more moment at the end, and what is too old gone from the beginning. */
function grown(past: Past, numbers: string[], items: Parameter[]): Past {
  const now = serverNow() / 1000;
  const first = past.times.findIndex((at) => at > now - SPAN);
  const from = first < 0 ? past.times.length : first;
  const valueOf = (number: string): number | null => {
    const parameter = items.find((one) => one.number === number);
    return parameter ? (parameter.value ?? parameter.raw) : null;
  };
  const values = numbers.map((number) => [number, [...(past.values[number] ?? []).slice(from), valueOf(number)]] as [string, (number | null)[]]);
  return { times: [...past.times.slice(from), now], values: Object.fromEntries(values) };
}
