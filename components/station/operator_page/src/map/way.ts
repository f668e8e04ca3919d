// SPDX-License-Identifier: Apache-2.0
// The way that a vehicle will take between places, as far as the map knows: the shortest one that keeps from walls. The
// vehicle's own plan does not cross the link.
import { type Point, distance } from "../model/geometry.ts";
import type { OccupancyGrid } from "../model/messages.ts";
import { isFree } from "./grid.ts";

/** Edge of a cell of the search [m]; finer maps are searched at this one. */
const cellM = 0.1;
/** The vehicle's middle keeps so far from walls [m]. */
const clearanceM = 0.2;
/** A place in a wall's clearance is left for the nearest free cell within so many cells. */
const escapeCells = 4;

/** Cells in which the vehicle's middle may be, and the shortest way through them. */
export class WayFinder {
  readonly #cell: number;
  readonly #columns: number;
  readonly #rows: number;
  readonly #origin: Point;
  readonly #open: Uint8Array;

  constructor(grid: OccupancyGrid) {
    const { resolution, width, height, origin } = grid.info;
    this.#cell = Math.max(cellM, resolution);
    this.#columns = Math.ceil((width * resolution) / this.#cell);
    this.#rows = Math.ceil((height * resolution) / this.#cell);
    this.#origin = origin.position;
    this.#open = this.#cleared(this.#free(grid));
  }

  /** From one place to another, both included; undefined: the map knows no way. */
  way(from: Point, to: Point): Point[] | undefined {
    const [start, goal] = [this.#nearestOpen(from), this.#nearestOpen(to)];
    if (start === undefined || goal === undefined) return undefined;
    const cells = this.#search(start, goal);
    if (cells === undefined) return undefined;
    return this.#straightened([from, ...cells.slice(1, -1).map((cell) => this.#middle(cell)), to]);
  }

  #free(grid: OccupancyGrid): Uint8Array {
    const free = new Uint8Array(this.#columns * this.#rows);
    for (let cell = 0; cell < free.length; ++cell) if (isFree(grid, this.#middle(cell))) free[cell] = 1;
    return free;
  }

  /** Without the cells that are near to others. */
  #cleared(free: Uint8Array): Uint8Array {
    const reach = Math.floor(clearanceM / this.#cell);
    const open = Uint8Array.from(free);
    for (let cell = 0; cell < free.length; ++cell) {
      if (free[cell] === 1) continue;
      const [column, row] = [cell % this.#columns, Math.floor(cell / this.#columns)];
      for (let dy = -reach; dy <= reach; ++dy) {
        for (let dx = -reach; dx <= reach; ++dx) {
          const near = this.#at(column + dx, row + dy);
          if (near !== undefined && Math.hypot(dx, dy) * this.#cell <= clearanceM) open[near] = 0;
        }
      }
    }
    return open;
  }

  #at(column: number, row: number): number | undefined {
    const isInside = column >= 0 && row >= 0 && column < this.#columns && row < this.#rows;
    return isInside ? row * this.#columns + column : undefined;
  }

  #middle(cell: number): Point {
    const [column, row] = [cell % this.#columns, Math.floor(cell / this.#columns)];
    return { x: this.#origin.x + (column + 0.5) * this.#cell, y: this.#origin.y + (row + 0.5) * this.#cell };
  }

  #cellOf({ x, y }: Point): [column: number, row: number] {
    return [Math.floor((x - this.#origin.x) / this.#cell), Math.floor((y - this.#origin.y) / this.#cell)];
  }

  #nearestOpen(place: Point): number | undefined {
    const [column, row] = this.#cellOf(place);
    let best: { cell: number; away: number } | undefined;
    for (let dy = -escapeCells; dy <= escapeCells; ++dy) {
      for (let dx = -escapeCells; dx <= escapeCells; ++dx) {
        const cell = this.#at(column + dx, row + dy);
        const away = Math.hypot(dx, dy);
        if (cell !== undefined && this.#open[cell] === 1 && (best === undefined || away < best.away)) best = { cell, away };
      }
    }
    return best?.cell;
  }

  /** A* over eight neighbours; steps across a corner only where both sides are open. */
  #search(start: number, goal: number): number[] | undefined {
    const cost = new Float32Array(this.#open.length).fill(Infinity);
    const before = new Int32Array(this.#open.length).fill(-1);
    const queue = new Queue();
    const rest = (cell: number): number => this.#steps(cell, goal);
    cost[start] = 0;
    queue.push(start, rest(start));
    for (let cell = queue.pop(); cell !== undefined; cell = queue.pop()) {
      if (cell === goal) return chain(before, goal);
      for (const [next, step] of this.#neighbours(cell)) {
        const reached = (cost[cell] ?? 0) + step;
        if (reached >= (cost[next] ?? 0) - 1e-4) continue;
        cost[next] = reached;
        before[next] = cell;
        queue.push(next, reached + rest(next));
      }
    }
    return undefined;
  }

  #steps(a: number, b: number): number {
    const across = Math.abs((a % this.#columns) - (b % this.#columns));
    const up = Math.abs(Math.floor(a / this.#columns) - Math.floor(b / this.#columns));
    return Math.max(across, up) + (Math.SQRT2 - 1) * Math.min(across, up);
  }

  #neighbours(cell: number): [cell: number, step: number][] {
    const [column, row] = [cell % this.#columns, Math.floor(cell / this.#columns)];
    const isOpen = (dx: number, dy: number): boolean => this.#open[this.#at(column + dx, row + dy) ?? -1] === 1;
    const found: [number, number][] = [];
    for (const [dx, dy] of directions) {
      if (!isOpen(dx, dy) || (dx !== 0 && dy !== 0 && !(isOpen(dx, 0) && isOpen(0, dy)))) continue;
      found.push([cell + dy * this.#columns + dx, Math.hypot(dx, dy)]);
    }
    return found;
  }

  /** Without the corners that a straight line may leave out. */
  #straightened(points: Point[]): Point[] {
    const kept = points.slice(0, 1);
    for (let index = 1; index < points.length - 1; ++index) {
      const [last, next] = [kept.at(-1), points[index + 1]];
      if (last && next && !this.#sees(last, next)) kept.push(points[index] as Point);
    }
    return [...kept, ...points.slice(-1)];
  }

  #sees(a: Point, b: Point): boolean {
    const steps = Math.ceil((2 * distance(a, b)) / this.#cell);
    for (let step = 1; step < steps; ++step) {
      const share = step / steps;
      const cell = this.#at(...this.#cellOf({ x: a.x + share * (b.x - a.x), y: a.y + share * (b.y - a.y) }));
      if (cell === undefined || this.#open[cell] !== 1) return false;
    }
    return true;
  }
}

const directions = [[1, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [1, -1], [-1, 1], [-1, -1]] as const;

function chain(before: Int32Array, goal: number): number[] {
  const cells = [goal];
  for (let cell = before[goal] ?? -1; cell >= 0; cell = before[cell] ?? -1) cells.unshift(cell);
  return cells;
}

/** Cells by their rank, the least first to a tenth of a step. */
class Queue {
  #buckets: number[][] = [];
  #least = 0;

  push(cell: number, rank: number): void {
    const bucket = Math.floor(10 * rank);
    (this.#buckets[bucket] ??= []).push(cell);
    this.#least = Math.min(this.#least, bucket);
  }

  pop(): number | undefined {
    for (; this.#least < this.#buckets.length; ++this.#least) {
      const cell = this.#buckets[this.#least]?.pop();
      if (cell !== undefined) return cell;
    }
    return undefined;
  }
}

/** New legs that one call searches: a picture is not held up by a mission of a thousand places. */
const mostSearches = 4;

/** Farther from the way that was found [m] the vehicle takes another one. */
const strayM = 0.4;

/** The way from the vehicle through places ahead, searched anew only where something has changed. */
export class WayAhead {
  #map: OccupancyGrid | undefined;
  #finder: WayFinder | undefined;
  #legs = new Map<string, Point[]>();
  #first: { readonly to: Point; readonly way: Point[] } | undefined;
  #searches = 0;
  /** Whether all legs were searched; if not, the next call goes on. */
  isComplete = true;

  /** Lines, with a gap where the map knows no way; straight without a map. Searches few new legs in each call. */
  through(map: OccupancyGrid | undefined, from: Point | undefined, places: readonly Point[]): Point[][] {
    if (map !== this.#map) this.#begin(map);
    this.#searches = 0;
    this.isComplete = true;
    const [next, ...others] = places;
    if (next === undefined) return [];
    const used = new Map<string, Point[]>();
    const legs = others.map((to, index) => this.#leg(places[index] ?? to, to, used));
    this.#legs = used;
    return joined(from === undefined ? legs : [this.#fromVehicle(from, next), ...legs]);
  }

  #begin(map: OccupancyGrid | undefined): void {
    this.#map = map;
    this.#finder = map && new WayFinder(map);
    this.#legs.clear();
    this.#first = undefined;
  }

  /** Empty: there is no way, or it was not searched yet. */
  #leg(from: Point, to: Point, used: Map<string, Point[]>): Point[] {
    const key = `${from.x} ${from.y} ${to.x} ${to.y}`;
    const known = used.get(key) ?? this.#legs.get(key);
    if (known === undefined && ++this.#searches > mostSearches) {
      this.isComplete = false;
      return [];
    }
    const way = known ?? this.#search(from, to);
    used.set(key, way);
    return way;
  }

  #search(from: Point, to: Point): Point[] {
    return this.#finder === undefined ? [from, to] : this.#finder.way(from, to) ?? [];
  }

  #fromVehicle(from: Point, to: Point): Point[] {
    const known = this.#first;
    const isSame = known !== undefined && known.to.x === to.x && known.to.y === to.y;
    const rest = isSame ? restOf(known.way, from) : undefined;
    if (rest !== undefined) return [from, ...rest];
    this.#first = { to, way: this.#search(from, to) };
    return this.#first.way;
  }
}

/** Lines of ways that go on where the one before ends. */
function joined(ways: readonly Point[][]): Point[][] {
  const lines: Point[][] = [];
  let isOpen = false;
  for (const way of ways) {
    if (isOpen && way.length > 0) lines.at(-1)?.push(...way.slice(1));
    else if (way.length > 0) lines.push([...way]);
    isOpen = way.length > 0;
  }
  return lines;
}

/** What of a way lies before who is on it; undefined: nobody is. */
function restOf(way: readonly Point[], from: Point): Point[] | undefined {
  let best: { index: number; away: number } | undefined;
  for (let index = 1; index < way.length; ++index) {
    const away = distanceToLine(from, way[index - 1] as Point, way[index] as Point);
    if (best === undefined || away <= best.away) best = { index, away };
  }
  return best !== undefined && best.away <= strayM ? way.slice(best.index) : undefined;
}

function distanceToLine(point: Point, a: Point, b: Point): number {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const along = ((point.x - a.x) * dx + (point.y - a.y) * dy) / Math.max(1e-9, dx * dx + dy * dy);
  const share = Math.min(1, Math.max(0, along));
  return distance(point, { x: a.x + share * dx, y: a.y + share * dy });
}
