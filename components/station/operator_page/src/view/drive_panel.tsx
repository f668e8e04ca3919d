// SPDX-License-Identifier: Apache-2.0
import type { TargetedPointerEvent } from "preact";
import { useState } from "preact/hooks";

import { type Operator, pageNow } from "../operator.ts";
import { whyNotDrive } from "../orders/driver_seat.ts";
import { speedChoices } from "../orders/stick.ts";
import { Panel } from "./parts.tsx";

/** Driving by hand: who drives, why not, how fast, and the stick for a finger. */
export function DrivePanel({ operator }: { operator: Operator; now: number }) {
  const { seat } = operator;
  const [, redraw] = useState(0);
  const change = (act: () => void) => (): void => {
    act();
    redraw((count) => count + 1);
  };
  const take = change(() => (seat.taken ? seat.leave() : seat.take()));
  const isRefused = whyNotDrive(operator.driveConditions(pageNow())) !== undefined;
  const label = seat.taken ? "Let go" : seat.other ? "Ask for the wheel" : "Take the wheel";
  return (
    <Panel name="drive" title="Drive by hand">
      <div class="drive-body">
        <div class="drive-words">
          <p class={`seat ${seatState(operator).kind}`} role="status">{seatState(operator).text}</p>
          <span class="buttons">
            <button type="button" class={seat.taken || isRefused ? "" : "go"} aria-pressed={seat.taken} disabled={seat.asks}
              title="Driving by hand (M)" onClick={take}>
              {label} <kbd>M</kbd>
            </button>
            {seat.askedBy && <button type="button" onClick={change(() => seat.keep())}>Keep it</button>}
          </span>
          <button
            type="button"
            class="by-sight"
            aria-pressed={operator.bySight}
            title="Drive without a fresh picture"
            onClick={change(() => (operator.bySight = !operator.bySight))}
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
          aria-pressed={speeds === operator.speeds}
          onClick={change(() => (operator.speeds = speeds))}
        >
          {speeds.linear.toFixed(1)}
        </button>
      ))}
      <span class="muted">m/s</span>
    </div>
  );
}

function seatState(operator: Operator): { kind: "idle" | "ready" | "refused"; text: string } {
  const { seat } = operator;
  const refusal = whyNotDrive(operator.driveConditions(pageNow()));
  if (seat.askedBy) return { kind: "refused", text: `${seat.askedBy} asks for the wheel. Let go, or keep it.` };
  if (seat.asks) return { kind: "refused", text: `${seat.other} was asked for the wheel.` };
  if (!seat.taken && seat.lostTo) return { kind: "refused", text: `${seat.lostTo} has taken over.` };
  if (!seat.taken && seat.other) return { kind: "refused", text: `${seat.other} drives.` };
  if (refusal) return { kind: "refused", text: `Not by hand now: ${refusal}.` };
  if (!seat.taken) return { kind: "idle", text: "Take the wheel, then hold keys, stick or a pad's shoulder button." };
  if (seat.waitsForRest) return { kind: "refused", text: "Let go of keys and stick first." };
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
    operator.touch = { x: x / length, y: y / length };
    setKnob(operator.touch);
  };
  const letGo = (): void => {
    operator.touch = undefined;
    setKnob({ x: 0, y: 0 });
  };
  return (
    <div
      class={`stick${operator.seat.taken ? " taken" : ""}`}
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
