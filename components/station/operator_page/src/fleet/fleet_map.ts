// SPDX-License-Identifier: Apache-2.0
// The floor with all vehicles on it; all of it is shown.
import { type Sheet, drawGrid, drawLine, drawName, drawScale, drawVehicle } from "../map/draw.ts";
import { gridPixels, knownBounds } from "../map/grid.ts";
import { emptyCanvas, pictureOf } from "../map/picture.ts";
import { type Theme, readTheme } from "../map/theme.ts";
import { type Bounds, Viewport } from "../map/viewport.ts";
import { freshness } from "../model/freshness.ts";
import type { OccupancyGrid } from "../model/messages.ts";
import type { Fleet } from "./fleet.ts";

/** Older drawings are renewed though nothing came: ages grow. */
const redrawMs = 500;
/** Around vehicles on an unknown floor [m]. */
const marginM = 3;

export class FleetMap {
  #context: CanvasRenderingContext2D;
  #theme: Theme = readTheme();
  #floor: { of: OccupancyGrid; theme: Theme; picture: CanvasImageSource; bounds: Bounds | undefined } | undefined;
  #drawn = { version: -1, at: -Infinity };
  #frame = 0;
  #resize = new ResizeObserver(() => (this.#drawn.version = -1));
  #scheme = matchMedia("(prefers-color-scheme: light)");

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly fleet: Fleet,
    private readonly now: () => number,
  ) {
    const context = canvas.getContext("2d");
    if (context === null) throw new Error("this browser has no 2D canvas");
    this.#context = context;
    this.#resize.observe(canvas);
    this.#scheme.addEventListener("change", this.#newTheme);
    this.#frame = requestAnimationFrame(this.#animate);
  }

  dispose(): void {
    cancelAnimationFrame(this.#frame);
    this.#resize.disconnect();
    this.#scheme.removeEventListener("change", this.#newTheme);
  }

  #newTheme = (): void => {
    this.#theme = readTheme();
    this.#drawn.version = -1;
  };

  #animate = (): void => {
    this.#frame = requestAnimationFrame(this.#animate);
    const [now, version] = [this.now(), this.fleet.version];
    if (version === this.#drawn.version && now - this.#drawn.at < redrawMs) return;
    this.#drawn = { version, at: now };
    this.#draw(now);
  };

  #draw(now: number): void {
    const size = { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    if (size.width === 0 || size.height === 0) return;
    emptyCanvas(this.#context, size);
    const floor = this.#picture();
    const bounds = floor?.bounds ?? this.#boundsOfVehicles();
    if (bounds === undefined) return;
    const sheet: Sheet = { context: this.#context, view: Viewport.fitting(bounds, size), size, theme: this.#theme };
    if (floor) drawGrid(sheet, floor.of, floor.picture);
    for (const { member } of this.fleet.members) this.#drawMember(sheet, member.name, member.station, now);
    drawScale(sheet);
  }

  #drawMember(sheet: Sheet, name: string, { location, route }: Fleet["members"][number]["member"]["station"], now: number): void {
    if (location === undefined) return;
    const present = route.points().find(({ state }) => state === "present");
    if (present) drawLine(sheet, [location.value, present], sheet.theme.goal, 2, [4, 5]);
    const isFresh = freshness(location.at, now) === "fresh";
    drawVehicle(sheet, location.value, isFresh ? undefined : now - location.at);
    drawName(sheet, location.value, name);
  }

  #boundsOfVehicles(): Bounds | undefined {
    const places = this.fleet.members.flatMap(({ member }) => member.station.location?.value ?? []);
    if (places.length === 0) return undefined;
    const [x, y] = [places.map((place) => place.x), places.map((place) => place.y)];
    return {
      min: { x: Math.min(...x) - marginM, y: Math.min(...y) - marginM },
      max: { x: Math.max(...x) + marginM, y: Math.max(...y) + marginM },
    };
  }

  #picture(): { of: OccupancyGrid; picture: CanvasImageSource; bounds: Bounds | undefined } | undefined {
    const { map } = this.fleet;
    if (map === undefined) return undefined;
    const theme = this.#theme;
    if (this.#floor?.of !== map || this.#floor.theme !== theme) {
      this.#floor = { of: map, theme, picture: pictureOf(map, gridPixels(map, theme.grid)), bounds: knownBounds(map) };
    }
    return this.#floor;
  }
}
