/** Tells about one vehicle or station, between the form and the jobs. */
import type { ComponentChildren } from "preact";
import { selected } from "../store";
import { t } from "../texts";

export function Panel(props: { title: string; tag: string; colour: string; children: ComponentChildren }) {
  return (
    <section class="panel" aria-label={props.title}>
      <h2>
        <i class="dot" style={{ background: props.colour }} />
        {props.title}
        <span class="tag">{props.tag}</span>
        <button type="button" class="plain" aria-label={t("close")} onClick={() => (selected.value = null)}>
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
