// SPDX-License-Identifier: Apache-2.0
import { isFree } from "../map/grid.ts";
import type { OccupancyGrid } from "../model/messages.ts";
import { type MissionDraft, draftOf } from "../model/mission_draft.ts";
import type { Station } from "../model/station.ts";
import { MissionOrder } from "../orders/mission_order.ts";
import { type Phase, MissionRequest } from "../orders/mission_request.ts";
import type { Connection, UserRole } from "../protocol/connection.ts";
import { missionCommand } from "../protocol/published.ts";

const drawId = (): Uint8Array => crypto.getRandomValues(new Uint8Array(16));

/** What a mission depends on besides the vehicle. */
export interface MissionSurroundings {
  readonly map: () => OccupancyGrid | undefined;
  readonly isReplaying: () => boolean;
  readonly role: () => UserRole;
  /** Who else drives by hand; empty: nobody. */
  readonly otherDriver: () => string;
  readonly onFault: (text: string) => void;
  readonly onChange: () => void;
}

/** The operator's mission: its draft on the map, handed to mission_control, and what is asked of the present one. */
export class OperatorMission {
  /** A mission that is edited on the map; undefined: none. */
  draft: MissionDraft | undefined;
  /** The draft that mission_control has refused as it is. */
  refused: MissionDraft | undefined;
  readonly #order = new MissionOrder();
  readonly #request: MissionRequest;

  constructor(
    private readonly live: Station,
    private readonly connection: Connection,
    private readonly around: MissionSurroundings,
  ) {
    this.#request = new MissionRequest((service, request) => connection.call(service, request), drawId);
  }

  /** What mission_control answered to what was sent. */
  get phase(): Phase {
    return this.#request.phase;
  }

  get isPending(): boolean {
    return this.#request.isPending;
  }

  /** Why the draft cannot be sent as it is; undefined: it can. */
  whyNotSend(): string | undefined {
    const map = this.around.map();
    const other = this.around.otherDriver();
    const places = this.draft?.places ?? [];
    const blocked = places.findIndex((place) => map !== undefined && !isFree(map, place));
    if (this.around.isReplaying()) return "A recording is shown.";
    if (this.around.role() === "observer") return "You are an observer.";
    if (other !== "") return `${other} drives by hand: ask for control before.`;
    if (blocked >= 0) return `Place ${blocked + 1} is in a wall or beyond the map.`;
    if (places.length === 0) return "Press on the map, drag for the heading.";
    return this.isPending ? "Sent, no answer yet." : undefined;
  }

  /** Hands the draft to mission_control; one that is refused stays, to be mended. */
  async send(): Promise<void> {
    const { draft } = this;
    if (draft === undefined || this.whyNotSend() !== undefined) return;
    const accepted = await this.#request.send(draft.places);
    if (accepted && this.draft === draft) this.draft = undefined;
    this.refused = accepted ? undefined : draft;
    this.#onAnswer("the mission");
  }

  /** Begins a draft with what is left of the present mission. */
  edit(): void {
    this.draft = draftOf(this.live.route.points().filter(({ state }) => state !== "passed"));
  }

  async cancel(): Promise<void> {
    await this.#request.cancel();
    this.#onAnswer("its end");
  }

  /** mission_control holds the vehicle where it is. */
  pause(now: number): void {
    this.#order.pause(now);
  }

  /** The mission goes on with the waypoint where it was paused. */
  resume(now: number): void {
    this.#order.resume(now);
  }

  skipWaypoint(now: number): void {
    const mission = this.live.mission?.value;
    if (mission !== undefined) this.#order.skip(mission.waypoint, now);
  }

  tick(now: number): void {
    const words = this.#order.due(this.live.mission?.value, now);
    if (words !== undefined) this.connection.publish(missionCommand, { data: words });
    if (!this.#order.unheeded) return;
    this.#order.unheeded = false;
    this.around.onFault("mission_control has not done what was asked");
  }

  #onAnswer(what: string): void {
    this.around.onChange();
    if (this.phase.kind === "failed") this.around.onFault(`${what} is refused: ${this.phase.reason}`);
  }
}
