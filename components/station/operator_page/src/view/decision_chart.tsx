// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";

import { readTheme } from "../map/theme.ts";
import { type Decision, pauses } from "../model/series.ts";
import type { Side } from "../model/station.ts";

const shownS = 300;
const heightPx = 150;

/** QNI of both sides and the vehicle's statistic against its threshold; grey: the gate was closed. */
export function DecisionChart({ uxv, gcs, now }: { uxv: Side; gcs: Side; now: () => number }) {
  const element = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const frame = element.current;
    if (frame === null) return;
    const plot = new uPlot(options(frame.clientWidth, () => uxv.decisions.decisions), [[], [], [], [], []], frame);
    const renew = (): void => {
      const right = now() / 1000;
      plot.setData(aligned(uxv.decisions.decisions, gcs.decisions.decisions), false);
      plot.setScale("x", { min: right - shownS, max: right });
      plot.setScale("y", { min: 0, max: 100 });
      plot.setScale("statistic", { min: 0, max: topStatistic(uxv.decisions.decisions) });
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
  }, [uxv, gcs, now]);
  return <div ref={element} class="chart" aria-label="QNI and statistic of the last five minutes" />;
}

/** The columns of both sides over one time axis [s]. */
export function aligned(uxv: readonly Decision[], gcs: readonly Decision[]): uPlot.AlignedData {
  const column = (of: readonly Decision[], pick: (one: Decision) => number | null) =>
    [of.map(({ at }) => at / 1000), of.map(pick)] as uPlot.AlignedData;
  return uPlot.join([
    column(uxv, ({ qni }) => qni),
    column(gcs, ({ qni }) => qni),
    column(uxv, ({ statistic }) => statistic),
    column(uxv, ({ threshold }) => threshold),
  ]);
}

function topStatistic(decisions: readonly Decision[]): number {
  const values = decisions.flatMap(({ statistic, threshold }) => [statistic ?? 0, 1.3 * (threshold ?? 0)]);
  return Math.max(1, ...values.slice(-600));
}

function options(width: number, decisions: () => readonly Decision[]): uPlot.Options {
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
    legend: { live: false },
    cursor: { show: false },
    scales: { x: { time: true }, y: {}, statistic: {} },
    axes: [
      { ...axis, size: 26, values: (_, ticks) => ticks.map(clockText) },
      { ...axis, size: 34, incrs: [25, 50] },
      { ...axis, scale: "statistic", side: 1, size: 34, grid: { show: false } },
    ],
    series: [
      { label: "time" },
      { ...line, label: "QNI vehicle", stroke: theme.accent, width: 2 },
      { ...line, label: "QNI station", stroke: theme.muted, width: 1.5 },
      { ...line, label: "statistic", scale: "statistic", stroke: theme.warning, width: 2 },
      { ...line, label: "threshold", scale: "statistic", stroke: theme.warning, width: 1, dash: [5, 4] },
    ],
    hooks: { drawClear: [(plot) => shadePauses(plot, decisions(), theme.muted)] },
  };
}

const clockText = (second: number): string => new Date(second * 1000).toLocaleTimeString("en-GB");

function shadePauses(plot: uPlot, decisions: readonly Decision[], colour: string): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.globalAlpha = 0.22;
  ctx.fillStyle = colour;
  for (const [from, to] of pauses(decisions)) {
    const at = (ms: number): number =>
      Math.min(bbox.left + bbox.width, Math.max(bbox.left, plot.valToPos(ms / 1000, "x", true)));
    const [left, right] = [at(from), to === Infinity ? bbox.left + bbox.width : at(to)];
    if (right > left) ctx.fillRect(left, bbox.top, right - left, bbox.height);
  }
  ctx.restore();
}
