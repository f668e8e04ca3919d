// SPDX-License-Identifier: Apache-2.0
import type { Point } from "../model/geometry.ts";

/** A size on the screen [px of CSS]. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** A part of the map frame. */
export interface Bounds {
  readonly min: Point;
  readonly max: Point;
}

export const leastScale = 2;
export const greatestScale = 400;
const clampScale = (scale: number): number => Math.min(greatestScale, Math.max(leastScale, scale));

/** Which part of the map is shown: its middle, and how large a metre is [px]. A value. */
export class Viewport {
  constructor(
    readonly centre: Point = { x: 0, y: 0 },
    readonly scale: number = 30,
  ) {}

  /** From the map to the screen, whose y points down. */
  toScreen(point: Point, size: Size): Point {
    return {
      x: size.width / 2 + (point.x - this.centre.x) * this.scale,
      y: size.height / 2 - (point.y - this.centre.y) * this.scale,
    };
  }

  toMap(pixel: Point, size: Size): Point {
    return {
      x: this.centre.x + (pixel.x - size.width / 2) / this.scale,
      y: this.centre.y - (pixel.y - size.height / 2) / this.scale,
    };
  }

  /** As if the map were pushed by so many pixels. */
  panned(dx: number, dy: number): Viewport {
    return new Viewport(
      { x: this.centre.x - dx / this.scale, y: this.centre.y + dy / this.scale },
      this.scale,
    );
  }

  /** Larger by `factor`; what lies under `pixel` stays there. */
  zoomed(factor: number, pixel: Point, size: Size): Viewport {
    const scale = clampScale(this.scale * factor);
    const under = this.toMap(pixel, size);
    const moved = new Viewport(this.centre, scale).toMap(pixel, size);
    return new Viewport(
      { x: this.centre.x + under.x - moved.x, y: this.centre.y + under.y - moved.y },
      scale,
    );
  }

  centredAt(centre: Point): Viewport {
    return new Viewport(centre, this.scale);
  }

  /** All of `bounds` with a margin around, below the topmost `top` pixels. */
  static fitting({ min, max }: Bounds, size: Size, top = 0): Viewport {
    const margin = 0.94;
    const across = size.width / Math.max(1, max.x - min.x);
    const up = (size.height - top) / Math.max(1, max.y - min.y);
    const scale = clampScale(margin * Math.min(across, up));
    return new Viewport({ x: (min.x + max.x) / 2, y: (min.y + max.y) / 2 + top / 2 / scale }, scale);
  }
}
