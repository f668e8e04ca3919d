// SPDX-License-Identifier: Apache-2.0
import { type Topic, type Topics, isTopicRead } from "../model/messages.ts";
import { Station } from "../model/station.ts";
import type { BagFile, BagMessage } from "./bag_file.ts";

/** Plays a bag into a station of its own: what was known at its position, as it was known then. */
export class BagPlayer {
  station = new Station();
  /** Of the recording's clock [ms]. */
  position: number;
  playing = true;
  speed = 1;
  /** What is wrong with the bag; empty: nothing. */
  trouble = "";
  /** A seek is under way: the station is still that of before. */
  seeking = false;
  #lastTick: number | undefined;
  #coming: AsyncGenerator<BagMessage> | undefined;
  #next: BagMessage | undefined;
  #busy = false;
  /** Counts seeks: what belongs to an earlier one is dropped. */
  #turn = 0;

  constructor(
    readonly bag: BagFile,
    readonly name: string,
  ) {
    this.position = bag.begin;
    void this.seek(bag.begin);
  }

  /** To be called a few times a second; `now` [ms] counts only by its steps. */
  tick(now: number): void {
    const step = now - (this.#lastTick ?? now);
    this.#lastTick = now;
    if (this.playing && !this.seeking) this.position = Math.min(this.bag.end, this.position + step * this.speed);
    void this.#feed();
  }

  /** Everything as it was known at `to`; done when the promise is. */
  async seek(to: number): Promise<void> {
    const turn = ++this.#turn;
    const station = new Station();
    this.position = to;
    this.seeking = true;
    this.#coming = undefined;
    this.#next = undefined;
    try {
      for await (const one of this.bag.statesUntil(to)) {
        if (turn !== this.#turn) return;
        take(station, one);
      }
      const picture = await this.bag.pictureAt(to);
      if (turn !== this.#turn) return;
      if (picture) take(station, picture);
      this.station = station;
      this.#coming = this.bag.messages(to + 0.001);
    } catch (error) {
      this.trouble = String(error);
    }
    this.seeking = false;
  }

  /** Gives the station what is due. */
  async #feed(): Promise<void> {
    if (this.#busy || this.#coming === undefined) return;
    this.#busy = true;
    const turn = this.#turn;
    try {
      while (turn === this.#turn) {
        this.#next ??= (await this.#coming.next()).value as BagMessage | undefined;
        if (turn !== this.#turn || this.#next === undefined || this.#next.at > this.position) break;
        take(this.station, this.#next);
        this.#next = undefined;
      }
    } catch (error) {
      this.trouble = String(error);
      this.#coming = undefined;
    }
    if (turn !== this.#turn) this.#next = undefined;
    this.#busy = false;
  }
}

function take(station: Station, { topic, at, message }: BagMessage): void {
  if (isTopicRead(topic)) station.onMessage(topic, message as Topics[Topic], at);
}
