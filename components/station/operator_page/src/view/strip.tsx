// SPDX-License-Identifier: Apache-2.0
import { stripOf } from "../model/strip.ts";
import type { Operator } from "../operator.ts";

/** Vehicle, link in a word, PER and gate, in one line beside the stop. */
export function StripView({ operator, now }: { operator: Operator; now: number }) {
  const { link, step, per, gate, paused } = stripOf(operator.station, now);
  const colour = step === undefined ? "var(--bad)" : `var(--quality-${step})`;
  return (
    <dl class="strip" aria-label="Vehicle and link">
      <div><dt>Vehicle</dt><dd>{operator.server?.metadata.vehicle ?? "uxv"}</dd></div>
      <div><dt>Link</dt><dd><i style={`background: ${colour}`} />{link}</dd></div>
      <div><dt>Loss</dt><dd>{per}</dd></div>
      <div class={paused ? "paused" : ""}><dt>Gate</dt><dd>{gate}</dd></div>
    </dl>
  );
}
