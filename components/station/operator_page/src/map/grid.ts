// SPDX-License-Identifier: Apache-2.0
import type { Point } from "../model/geometry.ts";
import type { OccupancyGrid } from "../model/messages.ts";
import type { Bounds } from "./viewport.ts";

export type Rgba = readonly [number, number, number, number];

/** How cells are painted. */
export interface GridColours {
  readonly free: Rgba;
  readonly occupied: Rgba;
  readonly unknown: Rgba;
}

/** The walls of a building begin at this occupancy [%]. */
const occupiedFrom = 65;

/** Whether a vehicle may be sent there, as far as the map knows: the cell is free. */
export function isFree({ info, data }: OccupancyGrid, place: Point): boolean {
  const column = Math.floor((place.x - info.origin.position.x) / info.resolution);
  const row = Math.floor((place.y - info.origin.position.y) / info.resolution);
  if (column < 0 || row < 0 || column >= info.width || row >= info.height) return false;
  const cell = data[row * info.width + column] ?? -1;
  return cell >= 0 && cell < occupiedFrom;
}

/** Pixels of a map, the row with the greatest y first; 4 bytes each. */
export function gridPixels(grid: OccupancyGrid, colours: GridColours): Uint8ClampedArray<ArrayBuffer> {
  return pixelsOf(grid, (cell) =>
    cell < 0 ? colours.unknown : cell >= occupiedFrom ? colours.occupied : colours.free,
  );
}

/** The same of a map of the link's signal, `steps` from worst to best; what is not known is clear. */
export function signalPixels(grid: OccupancyGrid, steps: readonly Rgba[]): Uint8ClampedArray<ArrayBuffer> {
  const clear: Rgba = [0, 0, 0, 0];
  return pixelsOf(grid, (cell) => (cell < 0 ? clear : steps[signalStep(cell)]) ?? clear);
}

/** From 0, below -80 dBm, in steps of 10 dB: what a network's planner calls no link, poor, fair, good and very good. */
function signalStep(cell: number): number {
  const dbm = -30 - 0.6 * cell;
  return [-80, -70, -60, -50].filter((bound) => dbm >= bound).length;
}

function pixelsOf(grid: OccupancyGrid, colourOf: (cell: number) => Rgba): Uint8ClampedArray<ArrayBuffer> {
  const { width, height } = grid.info;
  const pixels = new Uint8ClampedArray(4 * width * height);
  for (let row = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      const cell = grid.data[row * width + column] ?? -1;
      pixels.set(colourOf(cell), 4 * ((height - 1 - row) * width + column));
    }
  }
  return pixels;
}

/** The part of the map that is not unknown; undefined when all of it is. Without rotation of the origin. */
export function knownBounds(grid: OccupancyGrid): Bounds | undefined {
  const { width, height, resolution, origin } = grid.info;
  let [left, right, bottom, top] = [width, -1, height, -1];
  for (let index = 0; index < width * height; ++index) {
    if ((grid.data[index] ?? -1) < 0) continue;
    const [column, row] = [index % width, Math.floor(index / width)];
    left = Math.min(left, column);
    right = Math.max(right, column);
    bottom = Math.min(bottom, row);
    top = Math.max(top, row);
  }
  if (right < left) return undefined;
  const { x, y } = origin.position;
  return {
    min: { x: x + left * resolution, y: y + bottom * resolution },
    max: { x: x + (right + 1) * resolution, y: y + (top + 1) * resolution },
  };
}
