// SPDX-License-Identifier: Apache-2.0
import type { OccupancyGrid, OccupancyGridUpdate } from "./messages.ts";

/** The map with a tile that changed; undefined: the tile is none of this map. Pure. */
export function withTile(map: OccupancyGrid, tile: OccupancyGridUpdate): OccupancyGrid | undefined {
  const { x, y, width, height, data } = tile;
  const fits = x >= 0 && y >= 0 && x + width <= map.info.width && y + height <= map.info.height;
  if (!fits || data.length !== width * height) return undefined;
  const cells = Int8Array.from(map.data);
  for (let row = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      cells[(y + row) * map.info.width + x + column] = data[row * width + column] ?? -1;
    }
  }
  return { ...map, data: cells };
}
