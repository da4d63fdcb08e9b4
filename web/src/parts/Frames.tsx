/** The last packets on a line, newest first, each explained field by field. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { get } from "../api";
import { clock } from "../shows";
import { language, t, tell } from "../texts";
import type { Traffic } from "../types";

const FRAMES_SHOWN = 30;
const FRAMES_EVERY = 2000;

export function Frames({ path }: { path: string }) {
  const list = useSignal<Traffic[] | null>(null);
  const box = useRef<HTMLElement>(null);
  useEffect(() => {
    let here = true;
    const read = async (): Promise<void> => {
      // Nothing moves away under somebody who reads a frame.
      if (box.current?.querySelector("details[open]")) return;
      try {
        const { items } = await get<{ items: Traffic[] }>(`${path}?lang=${language.value}`);
        if (here) list.value = items.slice(-FRAMES_SHOWN).reverse();
      } catch {
        /* The next round asks again. */
      }
    };
    void read();
    const timer = window.setInterval(() => void read(), FRAMES_EVERY);
    return () => {
      here = false;
      window.clearInterval(timer);
    };
  }, [path, language.value]);
  return (
    <section class="frames" ref={box}>
      <h3>{t("last_frames")}</h3>
      {list.value?.length === 0 && <p class="nothing">{t("no_frames")}</p>}
      {list.value?.map((traffic) => (
        <Frame key={`${traffic.at}${traffic.direction}${traffic.hex}`} traffic={traffic} />
      ))}
    </section>
  );
}

function Frame({ traffic }: { traffic: Traffic }) {
  const rows = traffic.frames.flatMap((frame) => frame.fields);
  const main = rows.find((row) => ["CMD", "MSG", "MESSAGE", "RESULT"].includes(row.name.toUpperCase()));
  const kind = traffic.frames.map((frame) => frame.kind.toUpperCase()).join(" + ");
  return (
    <details>
      <summary>
        <span class={traffic.direction}>{traffic.direction === "in" ? "←" : "→"}</span>
        <time>{clock(traffic.at)}</time>
        <b>{kind}</b>
        <span class="more">{main ? tell(main.meaning) || main.value : ""}</span>
      </summary>
      <code class="hex">{traffic.hex.match(/../g)?.join(" ")}</code>
      <table class="bits">
        <tbody>
          {rows.map((row, i) => (
            <tr key={i}>
              <th style={{ paddingLeft: `${row.depth * 0.7}em` }}>{row.name}</th>
              <td>{tell(row.value)}</td>
              <td>{tell(row.meaning)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </details>
  );
}

/** The same, asked for only once somebody opens it. */
export function LineFrames({ path }: { path: string }) {
  const open = useSignal(false);
  return (
    <details class="part acts" open={open.value} onToggle={(event) => (open.value = event.currentTarget.open)}>
      <summary>{t("last_frames")}</summary>
      {open.value && <Frames path={path} />}
    </details>
  );
}
