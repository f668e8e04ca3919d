// SPDX-License-Identifier: Apache-2.0
import { useState } from "preact/hooks";

import { type Role, roleOf } from "../model/messages.ts";
import { type Silence, type WhatIf, compare } from "../model/what_if.ts";
import type { Operator } from "../operator.ts";
import { number } from "./parts.tsx";

const policies = ["none", "threshold", "tocp", "tocp_dsp", "tocp_reverse", "belief"];

/** Tries another policy on the samples of the last minutes; its decisions are drawn with those that were made. */
export function WhatIfBar({ operator }: { operator: Operator }) {
  const { whatIf } = operator;
  const [host, setHost] = useState<Role>("uxv");
  const [policy, setPolicy] = useState("tocp");
  const [changes, setChanges] = useState("");
  const isLive = operator.recordings.player === undefined;
  return (
    <form
      class="what-if"
      aria-label="What if"
      onSubmit={(event) => {
        event.preventDefault();
        whatIf.ask({ host, policy, changes });
      }}
    >
      <b>What if</b>
      <select aria-label="Whose decisions" value={host} onChange={({ currentTarget }) => setHost(roleOf(currentTarget.value) ?? "uxv")}>
        <option value="uxv">the vehicle</option>
        <option value="gcs">the station</option>
      </select>
      <select aria-label="Policy" value={policy} onChange={({ currentTarget }) => setPolicy(currentTarget.value)}>
        {policies.map((name) => <option key={name}>{name}</option>)}
      </select>
      <input aria-label="Parameters" type="text" placeholder="alpha=3,th_max_s=20" value={changes}
        onInput={({ currentTarget }) => setChanges(currentTarget.value)} />
      <button type="submit" disabled={!isLive}>Decide again</button>
      {whatIf.question && <button type="button" onClick={() => whatIf.clear()}>Clear</button>}
      {whatIf.trouble && <p class="refused">{whatIf.trouble}</p>}
      {whatIf.result && <Outcome operator={operator} result={whatIf.result} />}
    </form>
  );
}

function Outcome({ operator, result }: { operator: Operator; result: WhatIf }) {
  const { question } = result;
  const both = compare(result, operator.live.side(question.host).decisions.decisions);
  if (both === undefined) return <p class="muted">No decision in the last minutes.</p>;
  return (
    <p>
      In the last {number(both.seconds / 60, 1, "min")} <b class="operator-goal">{question.policy} {question.changes}</b> would have
      had {silenceText(both.other)}; there {both.happened.pauses === 1 ? "was" : "were"} {silenceText(both.happened)}.
    </p>
  );
}

const silenceText = ({ pauses, seconds }: Silence): string =>
  pauses === 0 ? "no pauses" : `${pauses} ${pauses === 1 ? "pause" : "pauses"}, ${number(seconds, 0, "s")} silent`;
