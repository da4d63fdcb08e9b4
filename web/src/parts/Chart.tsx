/** A chart over time. */
import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { theme } from "../theme";
import { none } from "../known";
import { language, t } from "../texts";

export interface Line {
  label: string;
  /** A custom property of the style sheet. */
  colour: string;
  values: (number | null)[];
  bars?: boolean;
}

const HEIGHT = 190;
/** How moments stand under a chart, from years down to seconds: the form, and what is added where the day changes. */
const MOMENTS: uPlot.Axis.DynamicValues | (string | number | null)[][] = [
  [3600 * 24 * 365, "{YYYY}", null, null, null, null, null, null, 1],
  [3600 * 24 * 28, "{YYYY}-{MM}", null, null, null, null, null, null, 1],
  [3600 * 24, "{MM}-{DD}", "\n{YYYY}", null, null, null, null, null, 1],
  [60, "{HH}:{mm}", "\n{MM}-{DD}", null, "\n{MM}-{DD}", null, null, null, 1],
  [1, "{HH}:{mm}:{ss}", "\n{MM}-{DD}", null, "\n{MM}-{DD}", null, null, null, 1],
];

interface Shown {
  label: string;
  times: number[];
  lines: Line[];
  unit: string;
}

/** `times` in seconds since 1970, one for each value. Without any value there are words in place of empty axes. */
export function Chart(shown: Shown) {
  if (shown.lines.some(({ values }) => values.some((value) => value !== null))) return <Drawn {...shown} />;
  return (
    <figure class="chart">
      <figcaption>{shown.label}</figcaption>
      <p class="nothing">{none(t("nothing_in_period"))}</p>
    </figure>
  );
}

function Drawn({ label, times, lines, unit }: Shown) {
  const box = useRef<HTMLDivElement>(null);
  const wears = theme.value;
  useEffect(() => {
    const parent = box.current as HTMLDivElement;
    const style = getComputedStyle(document.documentElement);
    const of = (name: string): string => style.getPropertyValue(name).trim();
    const axis = { stroke: of("--dim"), grid: { stroke: of("--line"), width: 1 }, ticks: { stroke: of("--line"), width: 1 } };
    const chart = new uPlot(
      {
        width: parent.clientWidth,
        height: HEIGHT,
        series: [
          { label: t("when"), value: "{YYYY}-{MM}-{DD} {HH}:{mm}" },
          ...lines.map((line) => ({
            label: line.label,
            stroke: of(line.colour),
            width: 2,
            ...(line.bars ? { fill: `${of(line.colour)}66`, paths: uPlot.paths.bars?.({ size: [0.8, 40] }) as uPlot.Series.PathBuilder } : {}),
          })),
        ],
        axes: [{ ...axis, values: MOMENTS as uPlot.Axis.Values }, { ...axis, label: unit, labelSize: 16, stroke: of("--dim") }],
        cursor: { drag: { x: true, y: false } },
      },
      [times, ...lines.map(({ values }) => values)] as uPlot.AlignedData,
      parent,
    );
    const size = new ResizeObserver(() => chart.setSize({ width: parent.clientWidth, height: HEIGHT }));
    size.observe(parent);
    return () => {
      size.disconnect();
      chart.destroy();
    };
  }, [wears, language.value, times, lines]);
  return (
    <figure class="chart">
      <figcaption>{label}</figcaption>
      <div ref={box} role="img" aria-label={label} />
    </figure>
  );
}
