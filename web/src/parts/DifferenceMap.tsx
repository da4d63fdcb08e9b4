/** The plan that runs with a difference laid over it: what comes, goes and changes, told apart by colour, line and sign. */
import { layout } from "../store";
import { t } from "../texts";
import { type Change, drawn, type How } from "../versions";

const SIGN: Record<How, string> = { same: "", added: "+", removed: "−", changed: "~" };
const SHOWN: How[] = ["same", "changed", "removed", "added"];

export function DifferenceMap({ changes }: { changes: Change[] }) {
  if (!layout.value) return null;
  const { track, marks, box } = drawn(layout.value, changes);
  const unit = Math.max(box.width, box.height) / 100;
  return (
    <figure class="difference">
      <svg viewBox={`${box.x} ${box.y} ${box.width} ${box.height}`} role="img" aria-label={t("what_differs")}>
        {SHOWN.map((how) => (
          <path key={how} d={track[how]} class={`track ${how}`} vector-effect="non-scaling-stroke" />
        ))}
        {marks.map((mark) => (
          <g key={`${mark.station} ${mark.name} ${mark.how}`} class={mark.how} data-mark={mark.name}>
            {mark.station ? (
              <rect x={mark.at[0] - unit * 0.8} y={mark.at[1] - unit * 0.8} width={unit * 1.6} height={unit * 1.6} />
            ) : (
              <circle cx={mark.at[0]} cy={mark.at[1]} r={unit * 0.6} />
            )}
            <text x={mark.at[0] + unit} y={mark.at[1] - unit * 0.7} font-size={unit * 2}>
              {SIGN[mark.how]} {mark.name}
            </text>
          </g>
        ))}
      </svg>
      <figcaption>
        {(["added", "removed", "changed"] as const).map((how) => (
          <span key={how} class={how}>
            {SIGN[how]} {t(`diff_${how}`)}
          </span>
        ))}
      </figcaption>
    </figure>
  );
}
