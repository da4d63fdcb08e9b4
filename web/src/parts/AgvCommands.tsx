/** What only AGVs are asked for: driven by hand, along their tape, to a destination by its name, or told at which tag they stand. */
import { useSignal } from "@preact/signals";
import type { Against } from "../against";
import { stopped } from "../around";
import { layout } from "../store";
import { t } from "../texts";
import { Choice, Field } from "./asking";
import { Sure } from "./Sure";
import type { Send } from "./VehicleCommands";

const NEEDS = "POST /vehicles/{vehicle}/commands";
const BY_HAND = ["forward", "backward", "turn_left", "turn_right"] as const;
const ALONG = ["forward", "backward"] as const;
const SPEEDS = ["slow", "normal", "fast"] as const;
const STEERING = ["straight", "left", "right"] as const;

export function AgvCommands({ send, against }: { send: Send; against: (command: string) => Against }) {
  const speed = useSignal<(typeof SPEEDS)[number]>("slow");
  const steering = useSignal<(typeof STEERING)[number]>("straight");
  const [tag, alias] = [useSignal(""), useSignal("")];
  return (
    <>
      <div class="fields">
        <Choice label={t("speed")} value={speed} of={SPEEDS.map((name) => [name, t(`speed_${name}`)] as const)} />
        <Choice label={t("at_forks")} value={steering} of={STEERING.map((name) => [name, t(`agv_${name}`)] as const)} />
      </div>
      <div class="acts-row" role="group" aria-label={t("by_hand")}>
        {BY_HAND.map((direction) => (
          <Sure key={direction} needs={NEEDS} label={t(`hand_${direction}`)} does={() => send({ command: "agv_move_manual", direction, speed: speed.value })} {...stopped(against("agv_move_manual"))} />
        ))}
        {ALONG.map((direction) => (
          <Sure
            key={direction}
            needs={NEEDS}
            label={t(`tape_${direction}`)}
            does={() => send({ command: "agv_move_auto", direction, steering: steering.value, speed: speed.value })}
            {...stopped(against("agv_move_auto"))}
          />
        ))}
      </div>
      <div class="fields">
        <Field label={t("agv_alias")} name="alias" value={alias} list="agv-aliases" />
        <div class="acts-row">
          <Sure needs={NEEDS} label={t("move")} disabled={!alias.value.trim()} does={() => send({ command: "agv_move_alias", alias: alias.value.trim() })} {...stopped(against("agv_move_alias"))} />
        </div>
        <Field label={t("stands_at_tag")} name="tag" value={tag} list="barcode-names" />
        <div class="acts-row">
          <Sure needs={NEEDS} label={t("tell_it")} disabled={!tag.value.trim()} does={() => send({ command: "agv_set_current", tag: tag.value.trim() })} {...stopped(against("agv_set_current"))} />
        </div>
      </div>
      <datalist id="agv-aliases">
        {layout.value?.chargers.flatMap((one) => (one.alias ? [<option key={one.id} value={one.alias} />] : []))}
      </datalist>
    </>
  );
}
