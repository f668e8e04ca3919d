// SPDX-License-Identifier: Apache-2.0
// What pointers, wheel and keys do on the map: move it, and edit a mission.
import { isWriting } from "../keys.ts";
import { type Point, distance } from "../model/geometry.ts";
import { type MissionDraft, add, draftOf, emptyDraft, moveBy, moveTo, placeAt, remove, reorder, select, turnBy, turnTo } from "../model/mission_draft.ts";
import type { Operator } from "../operator.ts";
import type { Size, Viewport } from "./viewport.ts";

/** Shorter drags [px] are a click: the heading stays. */
const headingDragPx = 12;
/** A place is taken within so many pixels: a finger is wide. */
const reachPx = 18;

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
  /** What the pointer does with the selected place, and the draft before it went down. */
  #edit: { readonly kind: "move" | "turn"; readonly before: MissionDraft } | undefined;

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
    const { station } = this.operator;
    const { draft } = this.operator.mission;
    if (this.#pointers.size > 1) return this.#takeBack();
    if (this.operator.place.isArmed) return this.#placed(() => this.operator.place.press(this.map.view.toMap(pixel, this.map.size())));
    if (draft === undefined) return;
    const place = this.map.view.toMap(pixel, this.map.size());
    const taken = placeAt(draft, place, reachPx / this.map.view.scale);
    this.#edit = { kind: taken === undefined || event.shiftKey ? "turn" : "move", before: draft };
    this.#setDraft(taken === undefined ? add(draft, place, station.location?.value) : select(draft, taken));
  };

  /** Two fingers move the map: the first one has edited nothing. */
  #takeBack(): void {
    if (this.#edit && this.operator.mission.draft) this.#setDraft(this.#edit.before);
    this.#edit = undefined;
    this.operator.place.takeBack();
  }

  /** The place of the vehicle is being dragged, or has been. */
  #placed(change: () => void): void {
    change();
    this.map.touch();
    this.map.onChange();
  }

  #move = (event: PointerEvent): void => {
    const before = this.#pointers.get(event.pointerId);
    if (before === undefined) return;
    const pixel = this.#pixelOf(event);
    const others = [...this.#pointers].filter(([id]) => id !== event.pointerId);
    const { place } = this.operator.place;
    if (place) return this.#turned(place, pixel, (yaw) => this.#placed(() => this.operator.place.turn(yaw)));
    if (this.#edit && this.operator.mission.draft) return this.#edited(this.#edit.kind, this.operator.mission.draft, pixel);
    this.#pointers.set(event.pointerId, pixel);
    const other = others[0]?.[1];
    if (other !== undefined) this.#pinch(other, before, pixel);
    else this.#pan(pixel.x - before.x, pixel.y - before.y);
  };

  #up = (event: PointerEvent): void => {
    this.#pointers.delete(event.pointerId);
    this.#edit = undefined;
    if (this.operator.place.place) this.#placed(() => this.operator.place.release(this.operator.now()));
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

  #edited(kind: "move" | "turn", draft: MissionDraft, pixel: Point): void {
    if (kind === "move") return this.#setDraft(moveTo(draft, this.map.view.toMap(pixel, this.map.size())));
    const place = draft.places[draft.selected ?? 0];
    if (place === undefined) return;
    this.#turned(place, pixel, (yaw) => this.#setDraft(turnTo(draft, yaw)));
  }

  /** The pointer is far enough from a place to say a heading. */
  #turned(place: Point, pixel: Point, turn: (yaw: number) => void): void {
    const from = this.map.view.toScreen(place, this.map.size());
    if (distance(from, pixel) >= headingDragPx) turn(Math.atan2(from.y - pixel.y, pixel.x - from.x));
  }

  #setDraft(draft: MissionDraft | undefined): void {
    this.operator.mission.draft = draft;
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
      l: () => operator.recordings.player ?? operator.place.toggle(),
      g: () => (operator.mission.draft = operator.mission.draft ? undefined : this.#firstDraft()),
    };
    const action = actions[event.key] ?? (operator.mission.draft ? this.#draftAction(event.key, operator.mission.draft) : undefined);
    action?.();
    return action !== undefined;
  }

  /** By keyboard a mission begins in the middle of what is seen. */
  #firstDraft(): MissionDraft {
    const { x, y } = this.map.view.centre;
    return document.activeElement === this.canvas ? draftOf([{ x, y, yaw: 0 }]) : emptyDraft;
  }

  #draftAction(key: string, draft: MissionDraft): (() => void) | undefined {
    const step = 12 / this.map.view.scale;
    const selected = draft.selected ?? -1;
    const { x, y } = draft.places[selected] ?? this.map.view.centre;
    const becomes = (next: MissionDraft) => (): void => void (this.operator.mission.draft = next);
    const actions: Record<string, () => void> = {
      ArrowUp: becomes(moveBy(draft, 0, step)),
      ArrowDown: becomes(moveBy(draft, 0, -step)),
      ArrowLeft: becomes(moveBy(draft, -step, 0)),
      ArrowRight: becomes(moveBy(draft, step, 0)),
      "[": becomes(turnBy(draft, Math.PI / 12)),
      "]": becomes(turnBy(draft, -Math.PI / 12)),
      Insert: becomes(add(draft, { x: x + 3 * step, y })),
      Delete: becomes(remove(draft)),
      Backspace: becomes(remove(draft)),
      PageUp: becomes(reorder(draft, -1)),
      PageDown: becomes(reorder(draft, 1)),
      ",": becomes(select(draft, selected - 1)),
      ".": becomes(select(draft, selected + 1)),
      Escape: () => (this.operator.mission.draft = undefined),
      Enter: () => void this.operator.mission.send(),
    };
    const isTaken = this.operator.driving.authority.taken && key.startsWith("Arrow");
    return isTaken ? undefined : actions[key];
  }
}
