// SPDX-License-Identifier: Apache-2.0
import type { StationBag } from "../protocol/station_files.ts";

const renewMs = 3000;

/** The station's recordings, renewed while somebody looks at them. */
export class BagList {
  shown = false;
  bags: readonly StationBag[] | undefined;
  /** Why there is no list; empty: there is one, or none was asked for. */
  trouble = "";
  #asked = -Infinity;

  constructor(private readonly get: () => Promise<readonly StationBag[]>) {}

  show(shown: boolean): void {
    this.shown = shown;
    this.#asked = -Infinity;
  }

  /** To be called a few times a second. */
  tick(now: number): void {
    if (!this.shown || now - this.#asked < renewMs) return;
    this.#asked = now;
    void this.#renew();
  }

  async #renew(): Promise<void> {
    try {
      this.bags = await this.get();
      this.trouble = "";
    } catch (error) {
      this.trouble = error instanceof Error ? error.message : String(error);
    }
  }
}

/** "22 Nov, 14:03:12, 5:04 min, 12.3 MB"; of one that is still written only its size. */
export function bagText({ begin_s, end_s, bytes }: StationBag): string {
  const size = bytes < 1e6 ? `${(bytes / 1000).toFixed(0)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
  if (begin_s === undefined || end_s === undefined) return `still being written, ${size}`;
  const seconds = Math.round(end_s - begin_s);
  const length = `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")} min`;
  const options = { day: "numeric", month: "short", hour: "2-digit", minute: "2-digit", second: "2-digit" } as const;
  return `${new Date(begin_s * 1000).toLocaleString("en-GB", options)}, ${length}, ${size}`;
}
