// SPDX-License-Identifier: Apache-2.0
// The canvas of the map: its part of the map, its pictures, and what hands do on it.
import { type Freshness, freshness } from "../model/freshness.ts";
import { type Point, distance } from "../model/geometry.ts";
import type { OccupancyGrid, Waypoint } from "../model/messages.ts";
import { type Operator, pageNow } from "../operator.ts";
import { drawEllipse, drawGoal, drawGrid, drawLine, drawRoute, drawScale, drawTrail, drawVehicle } from "./draw.ts";
import { gridPixels, isFree, knownBounds } from "./grid.ts";
import { type Theme, readTheme } from "./theme.ts";
import { TrailPaths } from "./trail_paths.ts";
import { type Size, Viewport } from "./viewport.ts";

/** Shorter drags [px] are a click: the heading stays. */
const headingDragPx = 12;
/** Older drawings are renewed though nothing came: ages grow. */
const redrawMs = 500;

export class MapCanvas {
  follows = false;
  #view = new Viewport();
  #theme: Theme = readTheme();
  #trail = new TrailPaths(() => new Path2D());
  #grid: { of: OccupancyGrid; picture: HTMLCanvasElement } | undefined;
  /** Nobody has moved the map: it shows all. */
  #showsAll = true;
  #pointers = new Map<number, Point>();
  #choosing = false;
  #drawn = { version: -1, at: -Infinity };
  #frame = 0;
  #context: CanvasRenderingContext2D;
  #resize = new ResizeObserver(() => this.#touch());
  #scheme = matchMedia("(prefers-color-scheme: light)");

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly operator: Operator,
    /** A tool's state has changed. */
    private readonly onChange: () => void,
  ) {
    const context = canvas.getContext("2d");
    if (context === null) throw new Error("this browser has no 2D canvas");
    this.#context = context;
    this.#resize.observe(canvas);
    canvas.addEventListener("pointerdown", this.#down);
    canvas.addEventListener("pointermove", this.#move);
    for (const name of ["pointerup", "pointercancel"] as const) canvas.addEventListener(name, this.#up);
    canvas.addEventListener("wheel", this.#wheel, { passive: false });
    window.addEventListener("keydown", this.#key);
    this.#scheme.addEventListener("change", this.#newTheme);
    this.#frame = requestAnimationFrame(this.#animate);
  }

  dispose(): void {
    cancelAnimationFrame(this.#frame);
    this.#resize.disconnect();
    window.removeEventListener("keydown", this.#key);
    this.#scheme.removeEventListener("change", this.#newTheme);
  }

  zoom(factor: number): void {
    const { width, height } = this.#size();
    this.#setView(this.#view.zoomed(factor, { x: width / 2, y: height / 2 }, { width, height }));
  }

  /** Shows the whole map, or the trail where there is none. */
  fit(): void {
    this.#showsAll = true;
    this.follow(false);
  }

  #showAll(): void {
    const { map, trail, location } = this.operator.station;
    const points = trail.points.filter((point) => point !== "gap");
    const known = map && knownBounds(map);
    const places: Point[] = known ? [known.min, known.max] : location ? [...points, location.value] : points;
    if (places.length === 0) return;
    const [xs, ys] = [places.map(({ x }) => x), places.map(({ y }) => y)];
    const bounds = {
      min: { x: Math.min(...xs), y: Math.min(...ys) },
      max: { x: Math.max(...xs), y: Math.max(...ys) },
    };
    this.#view = Viewport.fitting(bounds, this.#size());
  }

  follow(follows: boolean): void {
    this.follows = follows;
    if (follows) this.#showsAll = false;
    this.#touch();
    this.onChange();
  }

  #size(): Size {
    return { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
  }

  #touch(): void {
    this.#drawn.version = -1;
  }

  #setView(view: Viewport): void {
    this.#view = view;
    this.#showsAll = false;
    this.#touch();
  }

  #newTheme = (): void => {
    this.#theme = readTheme();
    this.#grid = undefined;
    this.#touch();
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
    const size = this.#size();
    if (size.width === 0 || size.height === 0) return;
    this.#fitCanvas(size);
    const { station, goal, draft } = this.operator;
    if (this.#showsAll) this.#showAll();
    if (this.follows && station.location) this.#view = this.#view.centredAt(station.location.value);
    const sheet = { context: this.#context, view: this.#view, size, theme: this.#theme };
    if (station.map) drawGrid(sheet, station.map, this.#picture(station.map));
    this.#trail.update(station.trail);
    drawTrail(sheet, this.#trail);
    const place = station.location?.value;
    const isLed = goal.poses.length === 0;
    if (isLed) drawRoute(sheet, station.route.points(), place);
    if (station.plan && freshness(station.plan.at, now) !== "unknown") {
      drawLine(sheet, station.plan.value.poses.map(({ pose }) => pose.position), this.#theme.accent, 2, []);
    }
    if (place && !isLed) drawLine(sheet, [place, ...goal.poses], this.#theme.goal, 2, [6, 5]);
    goal.poses.forEach((one, index) => drawGoal(sheet, one, String(index + 1)));
    if (station.location) this.#drawVehicle(sheet, station.location.value, station.location.at, now);
    draft?.forEach((one, index) => drawGoal(sheet, one, String(index + 1)));
    drawScale(sheet);
  }

  #drawVehicle(sheet: Parameters<typeof drawVehicle>[0], location: Waypoint, at: number, now: number): void {
    const state: Freshness = freshness(at, now);
    const { ellipse } = this.operator.station.location?.value ?? { ellipse: undefined };
    if (ellipse && state === "fresh") drawEllipse(sheet, location, ellipse);
    drawVehicle(sheet, location, state === "fresh" ? undefined : now - at);
  }

  #fitCanvas({ width, height }: Size): void {
    const ratio = window.devicePixelRatio || 1;
    const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (this.canvas.width !== across || this.canvas.height !== down) {
      this.canvas.width = across;
      this.canvas.height = down;
    }
    this.#context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.#context.clearRect(0, 0, width, height);
  }

  #picture(grid: OccupancyGrid): HTMLCanvasElement {
    if (this.#grid?.of === grid) return this.#grid.picture;
    const picture = document.createElement("canvas");
    picture.width = grid.info.width;
    picture.height = grid.info.height;
    const pixels = new ImageData(gridPixels(grid, this.#theme.grid), grid.info.width, grid.info.height);
    picture.getContext("2d")?.putImageData(pixels, 0, 0);
    this.#grid = { of: grid, picture };
    return picture;
  }

  #pixelOf(event: PointerEvent | WheelEvent): Point {
    const box = this.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  #down = (event: PointerEvent): void => {
    const pixel = this.#pixelOf(event);
    this.canvas.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, pixel);
    const { draft, station } = this.operator;
    if (draft === undefined || this.#pointers.size > 1) return;
    this.#choosing = true;
    const place = this.#view.toMap(pixel, this.#size());
    const before = (event.shiftKey ? draft.at(-1) : undefined) ?? station.location?.value;
    const yaw = before ? Math.atan2(place.y - before.y, place.x - before.x) : 0;
    const kept = event.shiftKey ? draft : [];
    this.#setDraft([...kept, { ...place, yaw }]);
  };

  #move = (event: PointerEvent): void => {
    const before = this.#pointers.get(event.pointerId);
    if (before === undefined) return;
    const pixel = this.#pixelOf(event);
    const others = [...this.#pointers].filter(([id]) => id !== event.pointerId);
    if (this.#choosing) return this.#turn(pixel);
    this.#pointers.set(event.pointerId, pixel);
    const other = others[0]?.[1];
    if (other !== undefined) this.#pinch(other, before, pixel);
    else this.#pan(pixel.x - before.x, pixel.y - before.y);
  };

  #up = (event: PointerEvent): void => {
    this.#pointers.delete(event.pointerId);
    this.#choosing = false;
  };

  #wheel = (event: WheelEvent): void => {
    event.preventDefault();
    this.#setView(this.#view.zoomed(Math.exp(-event.deltaY / 400), this.#pixelOf(event), this.#size()));
  };

  #pan(dx: number, dy: number): void {
    if (this.follows) this.follow(false);
    this.#setView(this.#view.panned(dx, dy));
  }

  #pinch(fixed: Point, before: Point, after: Point): void {
    const factor = distance(fixed, after) / Math.max(1, distance(fixed, before));
    this.#setView(this.#view.zoomed(factor, fixed, this.#size()));
  }

  #turn(pixel: Point): void {
    const draft = this.operator.draft ?? [];
    const last = draft.at(-1);
    if (last === undefined) return;
    const from = this.#view.toScreen(last, this.#size());
    if (distance(from, pixel) < headingDragPx) return;
    const yaw = Math.atan2(from.y - pixel.y, pixel.x - from.x);
    this.#setDraft([...draft.slice(0, -1), { ...last, yaw }]);
  }

  #setDraft(draft: Waypoint[] | undefined): void {
    this.operator.draft = draft;
    this.#touch();
    this.onChange();
  }

  #key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === "Enter" && event.target instanceof HTMLButtonElement) return;
    if (!this.#obey(event)) return;
    event.preventDefault();
    this.#touch();
    this.onChange();
  };

  /** False: not a key of the map. */
  #obey(event: KeyboardEvent): boolean {
    const { operator } = this;
    const actions: Record<string, () => void> = {
      "+": () => this.zoom(1.4),
      "-": () => this.zoom(1 / 1.4),
      "0": () => this.fit(),
      f: () => this.follow(!this.follows),
      g: () => (operator.draft = operator.draft ? undefined : this.#firstDraft()),
    };
    const action = actions[event.key] ?? (operator.draft ? this.#draftAction(event.key, operator.draft) : undefined);
    action?.();
    return action !== undefined;
  }

  /** By keyboard a goal begins in the middle of what is seen. */
  #firstDraft(): Waypoint[] {
    const { x, y } = this.#view.centre;
    return document.activeElement === this.canvas ? [{ x, y, yaw: 0 }] : [];
  }

  #draftAction(key: string, draft: Waypoint[]): (() => void) | undefined {
    const step = 12 / this.#view.scale;
    const move = (dx: number, dy: number, turn = 0) => (): void => {
      const last = draft.at(-1) ?? { ...this.#view.centre, yaw: 0 };
      const moved = { x: last.x + dx * step, y: last.y + dy * step, yaw: wrap(last.yaw + turn) };
      this.operator.draft = [...draft.slice(0, -1), moved];
    };
    const actions: Record<string, () => void> = {
      ArrowUp: move(0, 1),
      ArrowDown: move(0, -1),
      ArrowLeft: move(-1, 0),
      ArrowRight: move(1, 0),
      "[": move(0, 0, Math.PI / 12),
      "]": move(0, 0, -Math.PI / 12),
      Escape: () => (this.operator.draft = undefined),
      Enter: () => {
        const { map } = this.operator.station;
        const isGood = draft.length > 0 && !this.operator.player && draft.every((place) => map === undefined || isFree(map, place));
        if (isGood) this.operator.driveTo(draft, pageNow());
      },
    };
    const isTaken = this.operator.seat.taken && key.startsWith("Arrow");
    return isTaken ? undefined : actions[key];
  }
}

const wrap = (angle: number): number => Math.atan2(Math.sin(angle), Math.cos(angle));
