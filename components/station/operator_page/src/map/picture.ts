// SPDX-License-Identifier: Apache-2.0
import type { OccupancyGrid } from "../model/messages.ts";
import type { Layer } from "./backdrop.ts";
import type { Size } from "./viewport.ts";

/** Makes a canvas of the page empty, with a pixel for each of the screen's; it is drawn on in pixels of CSS. */
export function emptyCanvas(context: CanvasRenderingContext2D, { width, height }: Size): void {
  const { canvas } = context;
  const ratio = window.devicePixelRatio || 1;
  const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== across || canvas.height !== down) {
    canvas.width = across;
    canvas.height = down;
  }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
}

/** A map in these colours, as a browser draws it. */
export function pictureOf({ info: { width, height } }: OccupancyGrid, pixels: Uint8ClampedArray<ArrayBuffer>): CanvasImageSource {
  const { image, context, resize } = newLayer();
  resize(width, height);
  context.putImageData(new ImageData(pixels, width, height), 0, 0);
  return image;
}

/** A canvas that is not on the page. */
export function newLayer(): Layer {
  const image = document.createElement("canvas");
  const context = image.getContext("2d");
  if (context === null) throw new Error("this browser has no 2D canvas");
  return {
    image,
    context,
    resize(width: number, height: number): void {
      image.width = width;
      image.height = height;
    },
  };
}
