// SPDX-License-Identifier: Apache-2.0
// What stands still on the map, in a picture of its own, so that a new place costs the same after a
// minute and after an hour.
import type { Point } from "../model/geometry.ts";
import type { OccupancyGrid } from "../model/messages.ts";
import type { Trail } from "../model/trail.ts";
import { type Sheet, drawAccessPoint, drawGrid, drawTrail } from "./draw.ts";
import { TrailPieces } from "./trail_pieces.ts";
import { Viewport } from "./viewport.ts";

/** Drawn behind what moves. */
export interface Scene {
  readonly map: OccupancyGrid | undefined;
  readonly linkMap: OccupancyGrid | undefined;
  readonly accessPoint: Point | undefined;
  readonly trail: Trail;
}

/** A canvas that is not on the page. */
export interface Layer {
  readonly image: CanvasImageSource;
  readonly context: CanvasRenderingContext2D;
  /** Makes it empty, of so many pixels. */
  resize(width: number, height: number): void;
}

/** What a browser makes. */
export interface Tools {
  layer(): Layer;
  path(): Path2D;
  /** Of a map, in the present colours. */
  picture(map: OccupancyGrid): CanvasImageSource;
  signalPicture(linkMap: OccupancyGrid): CanvasImageSource;
}

/** On each side the picture is larger than the canvas by this share of it, so that the map can be moved. */
const marginShare = 0.25;

/**
 * Map, signal, access point and the trail but for its tail. The picture grows by the trail's new points only; all
 * is drawn again when scale, size, colours, maps or access point change, when old points of the trail went
 * away, or when the map was moved beyond the picture's margin.
 */
export class Backdrop {
  #layer: Layer;
  #pieces: TrailPieces<Path2D>;
  #sheet: Sheet | undefined;
  #drawn: readonly unknown[] = [];

  constructor(private readonly tools: Tools) {
    this.#layer = tools.layer();
    this.#pieces = new TrailPieces(tools.path);
  }

  /** Onto a canvas with `ratio` pixels for each of CSS; the first thing there. */
  draw(sheet: Sheet, ratio: number, scene: Scene): void {
    const { size, view, theme, context } = sheet;
    const { map, linkMap, accessPoint, trail } = scene;
    const look = [view.scale, size.width, size.height, ratio, theme, map, linkMap, accessPoint?.x, accessPoint?.y, trail, trail.cuts];
    const isSame = look.every((one, index) => one === this.#drawn[index]) && this.#holds(sheet);
    const layer = isSame && this.#sheet ? this.#sheet : this.#begin(sheet, ratio, scene);
    this.#drawn = look;
    drawTrail(layer, this.#pieces.added(trail));
    const { x, y } = this.#offset(layer, sheet);
    // Whole pixels: the picture stays sharp.
    const whole = (length: number): number => Math.round(length * ratio) / ratio;
    context.drawImage(this.#layer.image, whole(x), whole(y), layer.size.width, layer.size.height);
    drawTrail(sheet, this.#pieces.tail(trail));
  }

  /** Where the picture's corner lies on the canvas [px]. */
  #offset(layer: Sheet, { view, size }: Sheet): Point {
    const middle = view.toScreen(layer.view.centre, size);
    return { x: middle.x - layer.size.width / 2, y: middle.y - layer.size.height / 2 };
  }

  /** Whether the picture covers all that is to be seen. */
  #holds(sheet: Sheet): boolean {
    const layer = this.#sheet;
    if (layer === undefined) return false;
    const { x, y } = this.#offset(layer, sheet);
    const { width, height } = sheet.size;
    return x <= 0 && y <= 0 && x + layer.size.width >= width && y + layer.size.height >= height;
  }

  #begin({ view, size, theme }: Sheet, ratio: number, { map, linkMap, accessPoint }: Scene): Sheet {
    const larger = (length: number): number => length + 2 * Math.ceil(length * marginShare);
    const layerSize = { width: larger(size.width), height: larger(size.height) };
    const { context } = this.#layer;
    this.#layer.resize(Math.round(layerSize.width * ratio), Math.round(layerSize.height * ratio));
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const sheet = { context, size: layerSize, theme, view: new Viewport(view.centre, view.scale) };
    this.#sheet = sheet;
    this.#pieces.restart();
    if (map) drawGrid(sheet, map, this.tools.picture(map));
    if (linkMap) drawGrid(sheet, linkMap, this.tools.signalPicture(linkMap));
    if (accessPoint) drawAccessPoint(sheet, accessPoint);
    return sheet;
  }
}
