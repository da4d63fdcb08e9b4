/** A chart that grows at its right end: each unit has a scale of its own, the first two an axis. */
import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { clock } from "../shows";
import { t } from "../texts";
import { theme } from "../theme";

export interface LiveLine {
  label: string;
  unit: string;
  values: (number | null)[];
}

const HEIGHT = 200;
const COLOURS = ["--look-moving", "--look-held", "--look-charging", "--look-handling", "--look-waiting", "--look-alarm"];

const timeOf = (seconds: number): string => clock(new Date(seconds * 1000).toISOString());

/** `times` in seconds since 1970. It is drawn anew only when other lines are wanted. */
export function LiveChart({ label, times, lines }: { label: string; times: number[]; lines: LiveLine[] }) {
  const box = useRef<HTMLDivElement>(null);
  const chart = useRef<uPlot | null>(null);
  const what = lines.map((line) => `${line.label} ${line.unit}`).join("\n");
  const wears = theme.value;
  useEffect(() => {
    const parent = box.current as HTMLDivElement;
    const style = getComputedStyle(document.documentElement);
    const of = (name: string): string => style.getPropertyValue(name).trim();
    const units = [...new Set(lines.map(({ unit }) => unit))];
    const axis = { stroke: of("--dim"), grid: { stroke: of("--line"), width: 1 }, ticks: { stroke: of("--line"), width: 1 } };
    const made = new uPlot(
      {
        width: parent.clientWidth,
        height: HEIGHT,
        series: [
          { label: t("when"), value: (_, at) => (at === null ? "–" : timeOf(at)) },
          ...lines.map(({ label: name, unit }, i) => ({
            label: unit ? `${name} (${unit})` : name,
            scale: `of ${unit}`,
            stroke: of(COLOURS[i % COLOURS.length] as string),
            width: 2,
            spanGaps: true,
          })),
        ],
        axes: [{ ...axis, space: 80, values: (_, at) => at.map(timeOf) }, ...units.slice(0, 2).map((unit, i) => ({ ...axis, scale: `of ${unit}`, side: (i ? 1 : 3) as uPlot.Axis.Side, grid: i ? { show: false } : axis.grid, ...(unit ? { label: unit, labelSize: 16 } : {}) }))],
      },
      [times, ...lines.map(({ values }) => values)] as uPlot.AlignedData,
      parent,
    );
    chart.current = made;
    const size = new ResizeObserver(() => made.setSize({ width: parent.clientWidth, height: HEIGHT }));
    size.observe(parent);
    return () => {
      size.disconnect();
      made.destroy();
      chart.current = null;
    };
  }, [wears, what]);
  useEffect(() => {
    const now = chart.current;
    now?.setData([times, ...lines.map(({ values }) => values)] as uPlot.AlignedData);
    // The newest values stand in the legend, unless somebody points at others.
    if (now && (now.cursor.left ?? -1) < 0) now.setLegend({ idx: times.length - 1 });
  }, [times, lines]);
  return (
    <figure class="chart">
      <figcaption>{label}</figcaption>
      <div ref={box} role="img" aria-label={label} data-points={times.length} />
    </figure>
  );
}
