/** Positions of the three taught axes, and what changes for whom. */
import { t } from "../texts";
import type { Axes, PulseChange } from "../types";
import { Name } from "./Name";

const AXES = ["shft", "rota", "lift"] as const;

export function Pulses({ axes, signed, before }: { axes: Axes | null; signed?: boolean; before?: Axes | null }) {
  if (!axes) return <>–</>;
  const text = (value: number | null): string => (value === null ? "–" : signed && value > 0 ? `+${value}` : String(value));
  return (
    <span class="pulses">
      {AXES.map((axis) => (
        <span key={axis} class={before && before[axis] !== axes[axis] ? "changed" : ""} title={axis.toUpperCase()}>
          {text(axes[axis])}
        </span>
      ))}
    </span>
  );
}

export function Changes({ changes }: { changes: PulseChange[] }) {
  if (changes.length === 0) return <p class="calm">{t("changes_nothing")}</p>;
  return (
    <table class="list changes">
      <thead>
        <tr>
          {[t("at_station"), t("vehicle"), t("old"), t("new"), ""].map((name) => (
            <th key={name}>
              <span>{name}</span>
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {changes.slice(0, 60).map((change) => (
          <tr key={change.station + change.vehicle}>
            <td>
              <Name id={change.station} />
            </td>
            <td>
              <Name id={change.vehicle} />
            </td>
            <td>
              <Pulses axes={change.old} />
            </td>
            <td>
              <Pulses axes={change.new} before={change.old} />
            </td>
            <td class="bad">{change.beyond}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
