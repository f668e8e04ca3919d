// SPDX-License-Identifier: Apache-2.0
// What pointers, wheel and keys do on the map: move it, and choose places with headings.
import { isWriting } from "../keys.ts";
import { type Point, distance } from "../model/geometry.ts";
import type { Waypoint } from "../model/messages.ts";
import { type Operator, pageNow } from "../operator.ts";
import { isFree } from "./grid.ts";
import type { Size, Viewport } from "./viewport.ts";

/** Shorter drags [px] are a click: the heading stays. */
const headingDragPx = 12;

/** The map that the hands work on. */
export interface HandledMap {
  readonly view: Viewport;
  readonly follows: boolean;
  size(): Size;
  setView(view: Viewport): void;
  zoom(factor: number): void;
  fit(): void;
  follow(follows: boolean): void;
  touch(): void;
  onChange(): void;
}

export class MapHands {
  #pointers = new Map<number, Point>();
  #choosing = false;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly operator: Operator,
    private readonly map: HandledMap,
  ) {
    canvas.addEventListener("pointerdown", this.#down);
    canvas.addEventListener("pointermove", this.#move);
    for (const name of ["pointerup", "pointercancel"] as const) canvas.addEventListener(name, this.#up);
    canvas.addEventListener("wheel", this.#wheel, { passive: false });
    window.addEventListener("keydown", this.#key);
  }

  /** The canvas's own listeners go with it. */
  dispose(): void {
    window.removeEventListener("keydown", this.#key);
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
    const place = this.map.view.toMap(pixel, this.map.size());
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
    this.map.setView(this.map.view.zoomed(Math.exp(-event.deltaY / 400), this.#pixelOf(event), this.map.size()));
  };

  #pan(dx: number, dy: number): void {
    if (this.map.follows) this.map.follow(false);
    this.map.setView(this.map.view.panned(dx, dy));
  }

  #pinch(fixed: Point, before: Point, after: Point): void {
    const factor = distance(fixed, after) / Math.max(1, distance(fixed, before));
    this.map.setView(this.map.view.zoomed(factor, fixed, this.map.size()));
  }

  #turn(pixel: Point): void {
    const draft = this.operator.draft ?? [];
    const last = draft.at(-1);
    if (last === undefined) return;
    const from = this.map.view.toScreen(last, this.map.size());
    if (distance(from, pixel) < headingDragPx) return;
    const yaw = Math.atan2(from.y - pixel.y, pixel.x - from.x);
    this.#setDraft([...draft.slice(0, -1), { ...last, yaw }]);
  }

  #setDraft(draft: Waypoint[] | undefined): void {
    this.operator.draft = draft;
    this.map.touch();
    this.map.onChange();
  }

  #key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === "Enter" && event.target instanceof HTMLButtonElement) return;
    if (isWriting(event.target)) return;
    if (!this.#obey(event)) return;
    event.preventDefault();
    this.map.touch();
    this.map.onChange();
  };

  /** False: not a key of the map. */
  #obey(event: KeyboardEvent): boolean {
    const { operator } = this;
    const actions: Record<string, () => void> = {
      "+": () => this.map.zoom(1.4),
      "-": () => this.map.zoom(1 / 1.4),
      "0": () => this.map.fit(),
      f: () => this.map.follow(!this.map.follows),
      g: () => (operator.draft = operator.draft ? undefined : this.#firstDraft()),
    };
    const action = actions[event.key] ?? (operator.draft ? this.#draftAction(event.key, operator.draft) : undefined);
    action?.();
    return action !== undefined;
  }

  /** By keyboard a goal begins in the middle of what is seen. */
  #firstDraft(): Waypoint[] {
    const { x, y } = this.map.view.centre;
    return document.activeElement === this.canvas ? [{ x, y, yaw: 0 }] : [];
  }

  #draftAction(key: string, draft: Waypoint[]): (() => void) | undefined {
    const step = 12 / this.map.view.scale;
    const move = (dx: number, dy: number, turn = 0) => (): void => {
      const last = draft.at(-1) ?? { ...this.map.view.centre, yaw: 0 };
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
        const { map } = this.operator;
        const isGood = draft.length > 0 && !this.operator.player && draft.every((place) => map === undefined || isFree(map, place));
        if (isGood) this.operator.driveTo(draft, pageNow());
      },
    };
    const isTaken = this.operator.seat.taken && key.startsWith("Arrow");
    return isTaken ? undefined : actions[key];
  }
}

const wrap = (angle: number): number => Math.atan2(Math.sin(angle), Math.cos(angle));
