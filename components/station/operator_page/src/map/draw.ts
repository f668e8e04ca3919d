// SPDX-License-Identifier: Apache-2.0
// What is drawn on the map, layer by layer. Lengths on the screen are pixels of CSS.
import { ageText } from "../model/freshness.ts";
import type { Ellipse, Point } from "../model/geometry.ts";
import type { OccupancyGrid, Waypoint } from "../model/messages.ts";
import type { MissionDraft } from "../model/mission_draft.ts";
import type { RoutePoint } from "../model/route.ts";
import type { Theme } from "./theme.ts";
import type { TrailPiece } from "./trail_pieces.ts";
import type { Size, Viewport } from "./viewport.ts";

/** A canvas with the part of the map that it shows. */
export interface Sheet {
  readonly context: CanvasRenderingContext2D;
  readonly view: Viewport;
  readonly size: Size;
  readonly theme: Theme;
}

const tau = 2 * Math.PI;

/** Runs `draw` in map coordinates: metres, y up. */
function inMap({ context, view, size }: Sheet, draw: () => void): void {
  context.save();
  context.translate(size.width / 2, size.height / 2);
  context.scale(view.scale, -view.scale);
  context.translate(-view.centre.x, -view.centre.y);
  draw();
  context.restore();
}

/** Runs `draw` at a place of the map, in pixels, with x along `yaw`. */
function at(sheet: Sheet, place: Point, yaw: number, draw: () => void): void {
  const { x, y } = sheet.view.toScreen(place, sheet.size);
  sheet.context.save();
  sheet.context.translate(x, y);
  sheet.context.rotate(-yaw);
  draw();
  sheet.context.restore();
}

export function drawGrid(sheet: Sheet, grid: OccupancyGrid, picture: CanvasImageSource): void {
  const { resolution, width, height, origin } = grid.info;
  const { context } = sheet;
  inMap(sheet, () => {
    context.imageSmoothingEnabled = sheet.view.scale * resolution < 3;
    context.translate(origin.position.x, origin.position.y + height * resolution);
    context.scale(resolution, -resolution);
    context.drawImage(picture, 0, 0, width, height);
  });
}

export function drawTrail(sheet: Sheet, pieces: readonly TrailPiece<Path2D>[]): void {
  const { context, theme, view } = sheet;
  inMap(sheet, () => {
    context.lineCap = "round";
    context.lineJoin = "round";
    for (const { look, path, beforeM } of pieces) {
      const paused = look % 2 === 1;
      context.strokeStyle = theme.quality[Math.floor(look / 2)] ?? theme.muted;
      context.lineWidth = (paused ? 3 : 5) / view.scale;
      context.setLineDash(paused ? [2 / view.scale, 6 / view.scale] : []);
      context.lineDashOffset = beforeM;
      context.stroke(path);
    }
  });
}

/** The way ahead, dashed, and the waypoints. */
export function drawRoute(sheet: Sheet, route: readonly RoutePoint[], way: readonly Point[][]): void {
  const { context, theme } = sheet;
  for (const line of way) drawLine(sheet, line, theme.goal, 2, [6, 5]);
  for (const point of route) {
    at(sheet, point, 0, () => {
      const isPresent = point.state === "present";
      context.beginPath();
      context.arc(0, 0, isPresent ? 11 : 8.5, 0, tau);
      context.fillStyle = isPresent ? theme.goal : theme.halo;
      context.fill();
      context.strokeStyle = point.state === "passed" ? theme.muted : theme.goal;
      context.lineWidth = 2;
      context.stroke();
      const colour = isPresent ? theme.halo : point.state === "passed" ? theme.muted : theme.text;
      drawLabel(context, String(point.number), isPresent ? 12 : 10, colour);
    });
  }
}

/** The access point of the radio: a mast with waves. */
export function drawAccessPoint(sheet: Sheet, place: Point): void {
  const { context, theme } = sheet;
  at(sheet, place, 0, () => {
    for (const [colour, width] of [[theme.halo, 5], [theme.text, 2]] as const) {
      context.strokeStyle = colour;
      context.lineWidth = width;
      context.beginPath();
      context.moveTo(0, -4);
      context.lineTo(0, 8);
      for (const radius of [5, 9]) {
        for (const side of [0, Math.PI]) {
          context.moveTo(radius * Math.cos(side - 0.8), -4 + radius * Math.sin(side - 0.8));
          context.arc(0, -4, radius, side - 0.8, side + 0.8);
        }
      }
      context.stroke();
    }
  });
}

export function drawLine(sheet: Sheet, points: readonly Point[], colour: string, width: number, dash: number[]): void {
  const { context, view, size } = sheet;
  if (points.length < 2) return;
  context.save();
  context.beginPath();
  for (const point of points) {
    const { x, y } = view.toScreen(point, size);
    context.lineTo(x, y);
  }
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.stroke();
  context.restore();
}

function drawLabel(context: CanvasRenderingContext2D, text: string, px: number, colour: string): void {
  context.fillStyle = colour;
  context.font = `600 ${px}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(text, 0, 0.5);
}

/** A mission that is edited: its way and its places, the selected one with a ring. */
export function drawDraft(sheet: Sheet, { places, selected }: MissionDraft, way: readonly Point[][]): void {
  for (const line of way) drawLine(sheet, line, sheet.theme.goal, 2, [2, 4]);
  places.forEach((place, index) => {
    drawGoal(sheet, place, String(index + 1));
    if (index === selected) drawRing(sheet, place);
  });
}

/** Where a person says the vehicle is. */
export function drawPlace(sheet: Sheet, place: Waypoint): void {
  drawGoal(sheet, place, "");
  drawRing(sheet, place);
}

function drawRing(sheet: Sheet, place: Point): void {
  at(sheet, place, 0, () => {
    sheet.context.beginPath();
    sheet.context.arc(0, 0, 15, 0, tau);
    sheet.context.strokeStyle = sheet.theme.text;
    sheet.context.lineWidth = 2;
    sheet.context.stroke();
  });
}

/** A place with a heading. */
function drawGoal(sheet: Sheet, goal: Waypoint, label: string): void {
  const { context, theme } = sheet;
  at(sheet, goal, goal.yaw, () => {
    context.lineWidth = 3;
    context.strokeStyle = theme.halo;
    arrow(context, 34);
    context.stroke();
    context.strokeStyle = theme.goal;
    context.fillStyle = theme.goal;
    context.lineWidth = 2;
    arrow(context, 34);
    context.stroke();
    context.beginPath();
    context.arc(0, 0, 10, 0, tau);
    context.fill();
  });
  at(sheet, goal, 0, () => drawLabel(context, label, 11, theme.halo));
}

function arrow(context: CanvasRenderingContext2D, length: number): void {
  context.beginPath();
  context.moveTo(0, 0);
  context.lineTo(length, 0);
  context.moveTo(length - 8, -6);
  context.lineTo(length, 0);
  context.lineTo(length - 8, 6);
}

export function drawEllipse(sheet: Sheet, place: Point, ellipse: Ellipse): void {
  const { context, theme, view } = sheet;
  at(sheet, place, ellipse.angle, () => {
    context.beginPath();
    context.ellipse(0, 0, ellipse.major * view.scale, ellipse.minor * view.scale, 0, 0, tau);
    context.globalAlpha = 0.18;
    context.fillStyle = theme.accent;
    context.fill();
    context.globalAlpha = 0.6;
    context.strokeStyle = theme.accent;
    context.lineWidth = 1;
    context.stroke();
  });
}

/** Where beams of the laser ended. */
export function drawScan({ context, theme, view, size }: Sheet, points: readonly Point[]): void {
  context.fillStyle = theme.bad;
  for (const point of points) {
    const { x, y } = view.toScreen(point, size);
    context.fillRect(x - 1.5, y - 1.5, 3, 3);
  }
}

/** Radius of the vehicle [m]; on the screen at least so many pixels. */
const vehicleRadiusM = 0.18;
const leastRadiusPx = 10;

/** The vehicle; one that was not heard for `ghostAgeMs` as a ghost, with its age. */
export function drawVehicle(sheet: Sheet, pose: Waypoint, ghostAgeMs: number | undefined): void {
  const { context, theme, view } = sheet;
  const radius = Math.max(leastRadiusPx, vehicleRadiusM * view.scale);
  const isGhost = ghostAgeMs !== undefined;
  at(sheet, pose, pose.yaw, () => {
    context.beginPath();
    context.moveTo(radius * 1.75, 0);
    context.arc(0, 0, radius, 0.75, tau - 0.75);
    context.closePath();
    context.lineWidth = 2;
    context.setLineDash(isGhost ? [4, 3] : []);
    context.fillStyle = isGhost ? "transparent" : theme.accent;
    context.strokeStyle = isGhost ? theme.bad : theme.halo;
    context.fill();
    context.stroke();
  });
  if (isGhost) drawNote(sheet, pose, radius, `last seen ${ageText(ghostAgeMs)} ago`, theme.bad);
}

/** Whose vehicle it is, above it. */
export function drawName(sheet: Sheet, place: Point, name: string): void {
  const radius = Math.max(leastRadiusPx, vehicleRadiusM * sheet.view.scale);
  drawNote(sheet, place, -radius - 29, name, sheet.theme.text);
}

/** How far a note of `width` that is centred at `x` is moved so that all of it is seen. */
export const noteShift = (x: number, width: number, available: number): number =>
  x < 0 || x > available ? 0 : Math.max(width / 2 - x, 0) + Math.min(available - width / 2 - x, 0);

/** `below`: from the place to 5 px above the note. */
function drawNote(sheet: Sheet, place: Point, below: number, text: string, colour: string): void {
  const { context, theme, view, size } = sheet;
  at(sheet, place, 0, () => {
    context.font = "600 12px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "top";
    const width = context.measureText(text).width + 12;
    const { x } = view.toScreen(place, size);
    context.translate(noteShift(x, width, size.width), 0);
    context.fillStyle = theme.halo;
    context.globalAlpha = 0.85;
    context.fillRect(-width / 2, below + 5, width, 19);
    context.globalAlpha = 1;
    context.fillStyle = colour;
    context.fillText(text, 0, below + 8);
  });
}

const niceLengthsM = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];

/** The longest nice length that fits in 110 px. */
export const scaleLengthM = (scale: number): number =>
  niceLengthsM.filter((metres) => metres * scale <= 110).at(-1) ?? 0.1;

export function drawScale({ context, view, size, theme }: Sheet): void {
  const metres = scaleLengthM(view.scale);
  const width = metres * view.scale;
  const [x, y] = [size.width - width - 14, size.height - 14];
  context.strokeStyle = theme.text;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x, y - 5);
  context.lineTo(x, y);
  context.lineTo(x + width, y);
  context.lineTo(x + width, y - 5);
  context.stroke();
  context.fillStyle = theme.text;
  context.font = "11px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "bottom";
  context.fillText(`${metres} m`, x + width / 2, y - 5);
}
