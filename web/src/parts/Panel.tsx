/** Tells about one vehicle or station, between the form and the jobs. */
import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";
import { selected } from "../store";
import { t } from "../texts";

export function Panel(props: { title: string; tag: string; colour: string; children: ComponentChildren }) {
  const opener = useRef(document.activeElement);
  const close = (): void => {
    selected.value = null;
    // Back to what it was opened by; where that is gone, to the room's own button.
    const back = opener.current?.isConnected && opener.current !== document.body ? opener.current : document.querySelector("nav.rooms [aria-current]");
    (back as HTMLElement | null)?.focus();
  };
  return (
    <section class="panel" aria-label={props.title}>
      <h2>
        <i class="dot" style={{ background: props.colour }} />
        {props.title}
        <span class="tag">{props.tag}</span>
        <button type="button" class="plain" aria-label={t("close")} onClick={close}>
          ✕
        </button>
      </h2>
      <div class="scroll body">{props.children}</div>
    </section>
  );
}

export function Fact(props: { name: string; children: ComponentChildren }) {
  return (
    <>
      <dt>{props.name}</dt>
      <dd>{props.children}</dd>
    </>
  );
}
