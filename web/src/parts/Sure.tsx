/** A button that wants to be pressed twice. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Call } from "../access";
import { t } from "../texts";
import { Button } from "./Button";

const PATIENCE = 3500;

export function Sure(props: { label: string; needs: Call; does: () => void; class?: string; disabled?: boolean | undefined; title?: string | undefined; against?: string | undefined }) {
  const armed = useSignal(false);
  useEffect(() => {
    if (!armed.value) return undefined;
    const timer = window.setTimeout(() => (armed.value = false), PATIENCE);
    return () => window.clearTimeout(timer);
  }, [armed.value]);
  const ready = armed.value && !props.against;
  const press = (): void => {
    if (armed.value) props.does();
    armed.value = !armed.value;
  };
  return (
    <Button
      needs={props.needs}
      class={`sure ${props.class ?? ""} ${ready ? "armed" : ""}`}
      disabled={props.disabled ?? false}
      title={props.title ?? ""}
      against={props.against}
      onClick={press}
    >
      {ready ? `${t("sure")} ${props.label}` : props.label}
    </Button>
  );
}
