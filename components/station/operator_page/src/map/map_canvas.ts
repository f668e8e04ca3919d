// SPDX-License-Identifier: Apache-2.0
// The canvas of the map: which part of it is shown, and its pictures.
import { type Freshness, freshness } from "../model/freshness.ts";
import { type OccupancyGrid, type Waypoint, scanTopics } from "../model/messages.ts";
import type { Operator } from "../operator.ts";
import { Backdrop } from "./backdrop.ts";
import { type Sheet, drawDraft, drawEllipse, drawLine, drawPlace, drawRoute, drawScale, drawScan, drawVehicle } from "./draw.ts";
import { gridPixels, knownBounds, signalPixels } from "./grid.ts";
import { MapHands } from "./map_hands.ts";
import { emptyCanvas, newLayer, pictureOf } from "./picture.ts";
import { type Theme, readTheme } from "./theme.ts";
import { type Bounds, type Size, Viewport } from "./viewport.ts";
import { WayAhead } from "./way.ts";

/** Older drawings are renewed though nothing came: ages grow. */
const redrawMs = 500;

/** The row of buttons above the map [px]. */
const toolsPx = 46;

export class MapCanvas {
  follows = false;
  showsScan = false;
  #view = new Viewport();
  #theme: Theme = readTheme();
  #backdrop = new Backdrop({
    layer: newLayer,
    path: () => new Path2D(),
    picture: (map) => this.#picture(map),
    signalPicture: (linkMap) => pictureOf(linkMap, signalPixels(linkMap, this.#theme.signal)),
  });
  #way = new WayAhead();
  #draftWay = new WayAhead();
  #grid: { of: OccupancyGrid; theme: Theme; picture: CanvasImageSource } | undefined;
  #known: { of: OccupancyGrid; bounds: Bounds | undefined } | undefined;
  /** Nobody has moved the map: it shows all. */
  #showsAll = true;
  #drawn = { version: -1, at: -Infinity };
  #frame = 0;
  #hands: MapHands;
  #context: CanvasRenderingContext2D;
  #resize = new ResizeObserver(() => this.touch());
  #scheme = matchMedia("(prefers-color-scheme: light)");

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly operator: Operator,
    /** A tool's state has changed. */
    readonly onChange: () => void,
  ) {
    const context = canvas.getContext("2d");
    if (context === null) throw new Error("this browser has no 2D canvas");
    this.#context = context;
    this.#resize.observe(canvas);
    this.#hands = new MapHands(canvas, operator, this);
    this.#scheme.addEventListener("change", this.#newTheme);
    this.#frame = requestAnimationFrame(this.#animate);
  }

  dispose(): void {
    cancelAnimationFrame(this.#frame);
    if (this.showsScan) this.showScan(false);
    this.#resize.disconnect();
    this.#hands.dispose();
    this.#scheme.removeEventListener("change", this.#newTheme);
  }

  zoom(factor: number): void {
    const { width, height } = this.size();
    this.setView(this.#view.zoomed(factor, { x: width / 2, y: height / 2 }, { width, height }));
  }

  /** Shows the whole map, or the trail where there is none. */
  fit(): void {
    this.#showsAll = true;
    this.follow(false);
  }

  #showAll(): void {
    const { map, station } = this.operator;
    if (map && this.#known?.of !== map) this.#known = { of: map, bounds: knownBounds(map) };
    const bounds = (map && this.#known?.bounds) ?? station.trail.bounds;
    if (bounds === undefined) return;
    this.#view = Viewport.fitting(bounds, this.size(), toolsPx);
  }

  follow(follows: boolean): void {
    this.follows = follows;
    if (follows) this.#showsAll = false;
    this.touch();
    this.onChange();
  }

  /** Whether the last turn of the laser is shown; it comes over the radio only then. */
  showScan(shows: boolean): void {
    this.showsScan = shows;
    for (const topic of scanTopics) this.operator.connection.want(topic, shows);
    if (!shows) this.operator.live.scan.forget();
    this.touch();
    this.onChange();
  }

  get view(): Viewport {
    return this.#view;
  }

  size(): Size {
    return { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
  }

  /** Something that is drawn has changed. */
  touch(): void {
    this.#drawn.version = -1;
  }

  /** From now on this part of the map is shown. */
  setView(view: Viewport): void {
    this.#view = view;
    this.#showsAll = false;
    this.touch();
  }

  #newTheme = (): void => {
    this.#theme = readTheme();
    this.touch();
  };

  #animate = (): void => {
    this.#frame = requestAnimationFrame(this.#animate);
    const now = this.operator.now();
    const { version } = this.operator;
    if (version === this.#drawn.version && Math.abs(now - this.#drawn.at) < redrawMs) return;
    this.#drawn = { version, at: now };
    this.#draw(now);
  };

  #draw(now: number): void {
    const size = this.size();
    if (size.width === 0 || size.height === 0) return;
    emptyCanvas(this.#context, size);
    const { station, map } = this.operator;
    const { draft } = this.operator.mission;
    if (this.#showsAll) this.#showAll();
    if (this.follows && station.location) this.#view = this.#view.centredAt(station.location.value);
    const sheet = { context: this.#context, view: this.#view, size, theme: this.#theme };
    const { accessPoint } = this.operator;
    const { linkMap, trail } = station;
    this.#backdrop.draw(sheet, window.devicePixelRatio || 1, { map, linkMap, accessPoint, trail });
    const place = station.location?.value;
    const route = station.route.points();
    const isOver = station.mission !== undefined && ["done", "aborted"].includes(station.mission.value.state);
    const ahead = isOver ? [] : route.filter(({ state }) => state !== "passed");
    drawRoute(sheet, route, this.#way.through(map, place, ahead));
    if (station.choice && freshness(station.choice.at, now) !== "unknown") {
      drawLine(sheet, station.choice.value.shortest, this.#theme.muted, 2, [3, 5]);
    }
    if (station.plan && freshness(station.plan.at, now) !== "unknown") {
      drawLine(sheet, station.plan.value.poses.map(({ pose }) => pose.position), this.#theme.accent, 2, []);
    }
    if (this.showsScan) drawScan(sheet, station.scan.points());
    if (station.location) this.#drawVehicle(sheet, station.location.value, station.location.at, now);
    if (draft) drawDraft(sheet, draft, this.#draftWay.through(map, place, draft.places));
    if (this.operator.place.place) drawPlace(sheet, this.operator.place.place);
    if (!this.#way.isComplete || !this.#draftWay.isComplete) this.touch();
    drawScale(sheet);
  }

  #drawVehicle(sheet: Sheet, location: Waypoint, at: number, now: number): void {
    const state: Freshness = freshness(at, now);
    const { ellipse } = this.operator.station.location?.value ?? { ellipse: undefined };
    if (ellipse && state === "fresh") drawEllipse(sheet, location, ellipse);
    drawVehicle(sheet, location, state === "fresh" ? undefined : now - at);
  }

  #picture(grid: OccupancyGrid): CanvasImageSource {
    const theme = this.#theme;
    if (this.#grid?.of === grid && this.#grid.theme === theme) return this.#grid.picture;
    const picture = pictureOf(grid, gridPixels(grid, theme.grid));
    this.#grid = { of: grid, theme, picture };
    return picture;
  }
}
