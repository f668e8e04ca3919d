// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";

import { type Theme, readTheme } from "../map/theme.ts";
import { type Decision, pauses } from "../model/series.ts";
import type { Side } from "../model/station.ts";
import type { WhatIf } from "../model/what_if.ts";

const shownS = 300;
const heightPx = 150;
const laneShare = 0.09;

interface Shown {
  readonly uxv: Side;
  readonly gcs: Side;
  readonly now: () => number;
  readonly whatIf: () => WhatIf | undefined;
}

/**
 * QNI of both sides and the vehicle's statistic against its threshold; grey: its gate was closed. A lane at the
 * bottom has what another policy would have done.
 */
export function DecisionChart({ uxv, gcs, now, whatIf }: Shown) {
  const element = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const frame = element.current;
    if (frame === null) return;
    const shade = (plot: uPlot, theme: Theme): void => {
      shadePauses(plot, uxv.decisions.decisions, theme.muted, 1);
      drawLane(plot, whatIf(), theme);
    };
    const plot = new uPlot(options(frame.clientWidth, shade), [[], [], [], [], [], []], frame);
    const renew = (): void => {
      const right = now() / 1000;
      plot.setData(aligned(uxv.decisions.decisions, gcs.decisions.decisions, whatIf()?.decisions ?? []), false);
      plot.setScale("x", { min: right - shownS, max: right });
      plot.setScale("y", { min: 0, max: 100 });
      const statistics = [...uxv.decisions.decisions, ...(whatIf()?.decisions ?? [])];
      plot.setScale("statistic", { min: 0, max: topStatistic(statistics.filter(({ at }) => at > (right - shownS) * 1000)) });
    };
    renew();
    const timer = setInterval(renew, 1000);
    const resize = new ResizeObserver(() => plot.setSize({ width: frame.clientWidth, height: heightPx }));
    resize.observe(frame);
    return () => {
      clearInterval(timer);
      resize.disconnect();
      plot.destroy();
    };
  }, [uxv, gcs, now, whatIf]);
  return <div ref={element} class="chart" aria-label="QNI and statistic of the last five minutes" />;
}

/** The columns of both sides, and of what another policy would have done, over one time axis [s]. */
export function aligned(
  uxv: readonly Decision[],
  gcs: readonly Decision[],
  other: readonly Decision[],
): uPlot.AlignedData {
  const column = (of: readonly Decision[], pick: (one: Decision) => number | null) =>
    [of.map(({ at }) => at / 1000), of.map(pick)] as uPlot.AlignedData;
  return uPlot.join([
    column(uxv, ({ qni }) => qni),
    column(gcs, ({ qni }) => qni),
    column(uxv, ({ statistic }) => statistic),
    column(uxv, ({ threshold }) => threshold),
    column(other, ({ statistic }) => statistic),
  ]);
}

function topStatistic(decisions: readonly Decision[]): number {
  const values = decisions.flatMap(({ statistic, threshold }) => [statistic ?? 0, 1.3 * (threshold ?? 0)]);
  return Math.max(1, ...values);
}

function options(width: number, shade: (plot: uPlot, theme: Theme) => void): uPlot.Options {
  const theme = readTheme();
  const axis = {
    stroke: theme.muted,
    grid: { stroke: "rgba(128,140,150,0.18)", width: 1 },
    ticks: { show: false },
    font: "11px system-ui, sans-serif",
  };
  const line = { spanGaps: true, points: { show: false } };
  return {
    width,
    height: heightPx,
    legend: { live: false, markers: { width: 2, dash: (_, series) => legendDashes[series] ?? "solid" } },
    cursor: { show: false },
    scales: { x: { time: true }, y: {}, statistic: {} },
    axes: [
      { ...axis, size: 26, values: (_, ticks) => ticks.map(clockText) },
      { ...axis, ...titled("QNI"), stroke: theme.accent, size: 34, incrs: [25, 50] },
      { ...axis, ...titled("statistic"), stroke: theme.warning, scale: "statistic", side: 1, size: 34, grid: { show: false } },
    ],
    series: [
      { label: "time" },
      { ...line, label: "QNI vehicle", stroke: theme.accent, width: 2 },
      { ...line, label: "QNI station", stroke: theme.quality[4] ?? theme.muted, width: 2, dash: [2, 4] },
      { ...line, label: "statistic", scale: "statistic", stroke: theme.warning, width: 2 },
      { ...line, label: "threshold", scale: "statistic", stroke: theme.text, width: 1.5, dash: [10, 5] },
      { ...line, label: "what if", scale: "statistic", stroke: theme.goal, width: 1.5, dash: [4, 3] },
    ],
    hooks: { drawClear: [(plot) => shade(plot, theme)] },
  };
}

/** How the legend shows the lines, in the order of the series. */
const legendDashes = ["solid", "solid", "dotted", "solid", "dashed", "dashed"];

const titled = (label: string) => ({ label, labelSize: 14, labelGap: 0, labelFont: "11px system-ui, sans-serif" });

const clockText = (second: number): string => new Date(second * 1000).toLocaleTimeString("en-GB");

/** Shades pauses from the bottom up to a share of the height. */
function shadePauses(plot: uPlot, decisions: readonly Decision[], colour: string, share: number): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.globalAlpha = share === 1 ? 0.22 : 0.85;
  ctx.fillStyle = colour;
  const end = (decisions.at(-1)?.at ?? 0) / 1000;
  for (const [from, to] of pauses(decisions)) {
    const at = (second: number): number =>
      Math.min(bbox.left + bbox.width, Math.max(bbox.left, plot.valToPos(second, "x", true)));
    const goesOn = share === 1 ? bbox.left + bbox.width : at(end);
    const [left, right] = [at(from / 1000), to === Infinity ? goesOn : at(to / 1000)];
    if (right > left) ctx.fillRect(left, bbox.top + bbox.height * (1 - share), right - left, bbox.height * share);
  }
  ctx.restore();
}

/** The lane of what another policy would have done: filled where it would have paused. */
function drawLane(plot: uPlot, whatIf: WhatIf | undefined, theme: Theme): void {
  if (whatIf === undefined) return;
  const { ctx, bbox } = plot;
  const height = bbox.height * laneShare;
  ctx.save();
  ctx.strokeStyle = theme.goal;
  ctx.globalAlpha = 0.6;
  ctx.strokeRect(bbox.left, bbox.top + bbox.height - height, bbox.width, height);
  ctx.restore();
  shadePauses(plot, whatIf.decisions, theme.goal, laneShare);
}
