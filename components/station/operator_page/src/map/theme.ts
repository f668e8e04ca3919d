// SPDX-License-Identifier: Apache-2.0
import { qualitySteps } from "../model/quality.ts";
import type { GridColours, Rgba } from "./grid.ts";

/** The colours of the style sheet that canvases use. */
export interface Theme {
  readonly text: string;
  readonly muted: string;
  readonly accent: string;
  readonly warning: string;
  readonly bad: string;
  readonly goal: string;
  readonly halo: string;
  readonly quality: readonly string[];
  readonly grid: GridColours;
  /** Of the link's signal over the floor, worst first. */
  readonly signal: readonly Rgba[];
}

/** The floor shines through. */
const signalOf = ([red, green, blue]: Rgba): Rgba => [red, green, blue, 90];

export function readTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const colour = (name: string): string => style.getPropertyValue(`--${name}`).trim();
  const rgba = (name: string): Rgba => {
    const short = colour(name).replace("#", "");
    const hex = short.length === 3 ? short.replace(/./g, "$&$&") : short; // minified
    const part = (at: number): number => parseInt(hex.slice(at, at + 2), 16);
    return [part(0), part(2), part(4), hex.length === 8 ? part(6) : 255];
  };
  return {
    text: colour("text"),
    muted: colour("muted"),
    accent: colour("accent"),
    warning: colour("warning"),
    bad: colour("bad"),
    goal: colour("goal"),
    halo: colour("halo"),
    quality: Array.from({ length: qualitySteps }, (_, step) => colour(`quality-${step}`)),
    signal: Array.from({ length: qualitySteps }, (_, step) => signalOf(rgba(`quality-${step}`))),
    grid: {
      free: rgba("map-free"),
      occupied: rgba("map-wall"),
      unknown: rgba("map-unknown"),
    },
  };
}
