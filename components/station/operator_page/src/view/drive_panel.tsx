// SPDX-License-Identifier: Apache-2.0
import type { TargetedPointerEvent } from "preact";
import { useState } from "preact/hooks";

import type { Operator } from "../operator.ts";
import { whyNotDrive } from "../orders/control_authority.ts";
import { speedChoices } from "../orders/stick.ts";
import { pageNow } from "../page_now.ts";
import { Panel } from "./parts.tsx";

/** Driving by hand: who drives, why not, how fast, and the stick for a finger. */
export function DrivePanel({ operator }: { operator: Operator; now: number }) {
  const { authority } = operator.driving;
  const [, redraw] = useState(0);
  const change = (act: () => void) => (): void => {
    act();
    redraw((count) => count + 1);
  };
  const take = change(() => authority.toggle());
  const isRefused = whyNotDrive(operator.driving.conditions(pageNow())) !== undefined;
  const label = authority.taken ? "Let go" : authority.other ? "Ask for control" : "Take control";
  return (
    <Panel name="drive" title="Drive by hand">
      <div class="drive-body">
        <div class="drive-words">
          <p class={`authority ${stateOf(operator).kind}`} role="status">{stateOf(operator).text}</p>
          <span class="buttons">
            <button type="button" class={authority.taken || isRefused ? "" : "go"} aria-pressed={authority.taken} disabled={authority.asks || operator.role === "observer"}
              title="Driving by hand (M)" onClick={take}>
              {label} <kbd>M</kbd>
            </button>
            {operator.role === "supervisor" && authority.other &&
              <button type="button" title="Control is yours at once" onClick={change(() => authority.takeOver())}>Take over</button>}
            {authority.askedBy && <button type="button" onClick={change(() => authority.keep())}>Keep it</button>}
          </span>
          <button
            type="button"
            class="by-sight"
            aria-pressed={operator.driving.bySight}
            title="Drive without a fresh picture"
            onClick={change(() => (operator.driving.bySight = !operator.driving.bySight))}
          >
            I see the vehicle myself
          </button>
          <Speeds operator={operator} change={change} />
        </div>
        <Stick operator={operator} />
      </div>
    </Panel>
  );
}

function Speeds({ operator, change }: { operator: Operator; change: (act: () => void) => () => void }) {
  return (
    <div class="speeds" role="group" aria-label="Top speed">
      {speedChoices.map((speeds) => (
        <button
          type="button"
          key={speeds.linear}
          aria-pressed={speeds === operator.driving.speeds}
          onClick={change(() => (operator.driving.speeds = speeds))}
        >
          {speeds.linear.toFixed(1)}
        </button>
      ))}
      <span class="muted">m/s</span>
    </div>
  );
}

function stateOf(operator: Operator): { kind: "idle" | "ready" | "refused"; text: string } {
  const { authority } = operator.driving;
  const refusal = whyNotDrive(operator.driving.conditions(pageNow()));
  if (authority.askedBy) return { kind: "refused", text: `${authority.askedBy} asks for control. Let go, or keep it.` };
  if (authority.asks) return { kind: "refused", text: `${authority.other} was asked for control.` };
  if (!authority.taken && authority.lostTo) return { kind: "refused", text: `${authority.lostTo} has taken over.` };
  if (!authority.taken && authority.other) return { kind: "refused", text: `${authority.other} drives.` };
  if (refusal) return { kind: "refused", text: `Not by hand now: ${refusal}.` };
  if (!authority.taken) return { kind: "idle", text: "Take control, then hold keys, stick or a pad's shoulder button." };
  if (authority.waitsForRest) return { kind: "refused", text: "Let go of keys and stick first." };
  return { kind: "ready", text: "You drive: W A S D, arrows, stick or gamepad. Letting go stops." };
}

/** A stick for a finger or a mouse: touching it is the dead-man switch. */
function Stick({ operator }: { operator: Operator }) {
  const [knob, setKnob] = useState({ x: 0, y: 0 });
  const hold = (event: TargetedPointerEvent<HTMLDivElement>): void => {
    if (event.type === "pointerdown") event.currentTarget.setPointerCapture(event.pointerId);
    else if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
    const box = event.currentTarget.getBoundingClientRect();
    const x = (2 * (event.clientX - box.left)) / box.width - 1;
    const y = 1 - (2 * (event.clientY - box.top)) / box.height;
    const length = Math.max(1, Math.hypot(x, y));
    operator.driving.touch = { x: x / length, y: y / length };
    setKnob(operator.driving.touch);
  };
  const letGo = (): void => {
    operator.driving.touch = undefined;
    setKnob({ x: 0, y: 0 });
  };
  return (
    <div
      class={`stick${operator.driving.authority.taken ? " taken" : ""}`}
      aria-label="Stick: forward and back, left and right"
      onPointerDown={hold}
      onPointerMove={hold}
      onPointerUp={letGo}
      onPointerCancel={letGo}
      onLostPointerCapture={letGo}
      onContextMenu={(event) => event.preventDefault()}
    >
      <i style={`left: ${50 + 34 * knob.x}%; top: ${50 - 34 * knob.y}%`} />
    </div>
  );
}
