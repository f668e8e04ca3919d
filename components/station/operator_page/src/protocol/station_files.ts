// SPDX-License-Identifier: Apache-2.0
// What the station's server gives besides messages: its recordings, and decisions made again.
import type { Tables } from "../model/history.ts";
import { type BagSource, bearer, sourceOfUrl } from "../replay/bag_source.ts";

/** A recording of the station. */
export interface StationBag {
  /** Below the station's folder of recordings. */
  readonly path: string;
  readonly bytes: number;
  /** [s] since the Unix epoch; undefined: it is still being written, or its writer was killed. */
  readonly begin_s?: number;
  readonly end_s?: number;
}

export class StationFiles {
  #base: URL;
  #token: string;

  /** `page`: the address of the page, with its token. */
  constructor(
    page: string,
    private readonly get: typeof fetch = (...words) => fetch(...words),
  ) {
    this.#base = new URL(page);
    this.#token = this.#base.searchParams.get("token") ?? "";
    this.#base.search = "";
    this.#base.hash = "";
  }

  /** The newest first. Rejects with a text for people. */
  async bags(): Promise<readonly StationBag[]> {
    const { bags } = (await this.#json("bags")) as { bags?: StationBag[] };
    return bags ?? [];
  }

  source(bag: StationBag): BagSource {
    return sourceOfUrl(bag.path, this.#url(`bags/${bag.path}`), bag.bytes, this.get, this.#token);
  }

  /** A table of the station's recorder, as text; empty where there is none. */
  async table(name: keyof Tables): Promise<string> {
    return this.#text(`tables/${name}.csv`);
  }

  /** What `tocsin decide` says of a policy; `query`: host, policy, parameters. */
  whatIf(query: Readonly<Record<string, string>>): Promise<unknown> {
    return this.#json(`what_if?${new URLSearchParams(query)}`);
  }

  #url = (target: string): string => new URL(target, this.#base).href;

  async #json(target: string): Promise<unknown> {
    return JSON.parse(await this.#text(target));
  }

  async #text(target: string): Promise<string> {
    const answer = await this.get(this.#url(target), { headers: bearer(this.#token) });
    const text = await answer.text();
    if (!answer.ok) throw new Error(text.trim() || `the server answers ${answer.status}`);
    return text;
  }
}
