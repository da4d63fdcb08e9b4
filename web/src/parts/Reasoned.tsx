/** Decisions that want a reason: one line to write it, and the buttons. */
import { useSignal } from "@preact/signals";
import type { Call } from "../access";
import type { Against } from "../against";
import { inWords } from "../around";
import { t } from "../texts";
import { type Asking, Told, useAsking } from "./asking";
import { Button } from "./Button";
import { Sure } from "./Sure";

export interface Decision {
  label: string;
  needs: Call;
  does: (reason: string) => Promise<unknown>;
  /** Whether it can be decided without a reason. */
  bare?: boolean;
  /** A note may be written all the same. */
  noted?: boolean;
  /** There is nothing to decide just now. */
  idle?: boolean;
  /** Why the controller would refuse it. */
  against?: Against;
  /** Pressed twice, since it is hard to undo. */
  grave?: boolean;
}

export function Reasoned({ decisions, title, asking, hint }: { decisions: Decision[]; title?: string; asking?: Asking; hint?: string }) {
  const reason = useSignal("");
  const own = useAsking();
  const { ask, busy } = asking ?? own;
  const send = async ({ does }: Decision): Promise<void> => {
    if (await ask(() => does(reason.value.trim()))) reason.value = "";
  };
  const wanted = decisions.some((one) => !one.bare || one.noted);
  return (
    <div class="stack reasoned">
      {title && <h3>{title}</h3>}
      {wanted && (
        <input
          aria-label={hint ?? t("reason")}
          placeholder={hint ?? t("reason")}
          maxLength={200}
          value={reason.value}
          onInput={(event) => (reason.value = event.currentTarget.value)}
        />
      )}
      <div class="acts-row">
        {decisions.map((one) => {
          const lacks = !one.bare && !reason.value.trim();
          const why = one.against ? inWords(one.against) : lacks ? t("reason_first") : undefined;
          const idle = busy.value || one.idle === true;
          return one.grave ? (
            <Sure key={one.label} needs={one.needs} label={one.label} disabled={idle} against={why} does={() => void send(one)} />
          ) : (
            <Button key={one.label} needs={one.needs} disabled={idle} against={why} onClick={() => void send(one)}>
              {one.label}
            </Button>
          );
        })}
      </div>
      <Told asking={asking ?? own} />
    </div>
  );
}
