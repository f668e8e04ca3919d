// SPDX-License-Identifier: Apache-2.0
import type { Role } from "../model/messages.ts";
import { type WhatIf, type WhatIfQuestion, queryOf, whatIfOf } from "../model/what_if.ts";

const renewMs = 10_000;

/** A question to the station, what came of it, and the same again while it is looked at. */
export class WhatIfQuery {
  question: WhatIfQuestion | undefined;
  result: WhatIf | undefined;
  /** Why there is no answer; empty: there is one, or none was asked for. */
  trouble = "";
  #askedAt = -Infinity;
  #busy = false;

  constructor(
    private readonly get: (query: Readonly<Record<string, string>>) => Promise<unknown>,
    /** The page's time less the clock of a host [ms]; undefined: nothing of it was heard. */
    private readonly offset: (host: Role) => number | undefined,
  ) {}

  ask(question: WhatIfQuestion): void {
    this.question = question;
    this.result = undefined;
    this.trouble = "";
    this.#askedAt = -Infinity;
  }

  clear(): void {
    this.question = undefined;
    this.result = undefined;
    this.trouble = "";
  }

  /** To be called a few times a second. */
  tick(now: number): void {
    if (this.question === undefined || this.#busy || now - this.#askedAt < renewMs) return;
    this.#askedAt = now;
    this.#busy = true;
    void this.#ask(this.question);
  }

  async #ask(question: WhatIfQuestion): Promise<void> {
    try {
      const answer = await this.get(queryOf(question));
      const offset = this.offset(question.host);
      if (offset === undefined) throw new Error("no decision of this side was heard yet");
      if (question === this.question) {
        this.result = whatIfOf(answer, question, offset);
        this.trouble = "";
      }
    } catch (error) {
      if (question === this.question) this.trouble = error instanceof Error ? error.message : String(error);
    }
    this.#busy = false;
  }
}
