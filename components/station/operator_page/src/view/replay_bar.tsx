// SPDX-License-Identifier: Apache-2.0
import type { TargetedEvent } from "preact";

import type { Operator } from "../operator.ts";
import type { BagPlayer } from "../replay/bag_player.ts";

const speeds = [1, 2, 5, 20];

/** Goes through the bag that is shown. */
export function ReplayBar({ operator, player }: { operator: Operator; player: BagPlayer }) {
  const { bag, position } = player;
  const seek = (event: TargetedEvent<HTMLInputElement>): void => {
    void player.seek(bag.begin + Number(event.currentTarget.value) * 1000);
  };
  return (
    <div class="replay" role="group" aria-label="Recording">
      <button type="button" onClick={() => (player.playing = !player.playing)}>{player.playing ? "Pause" : "Play"}</button>
      <input
        type="range"
        aria-label="Position in the recording"
        min={0}
        max={(bag.end - bag.begin) / 1000}
        step={0.1}
        value={(position - bag.begin) / 1000}
        onInput={seek}
      />
      <span class="position">
        {clockText(position - bag.begin)} of {clockText(bag.end - bag.begin)}, {new Date(position).toLocaleString("en-GB")}
      </span>
      <span class="buttons" role="group" aria-label="Speed">
        {speeds.map((speed) => (
          <button type="button" key={speed} aria-pressed={speed === player.speed} onClick={() => (player.speed = speed)}>
            {speed}×
          </button>
        ))}
      </span>
      <button type="button" class="go" onClick={() => operator.recordings.close()}>Back to the vehicle</button>
      {player.seeking && <span class="muted">seeking</span>}
      {player.trouble && <span class="refused">{player.trouble}</span>}
    </div>
  );
}

function clockText(ms: number): string {
  const seconds = Math.max(0, Math.floor(ms / 1000));
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")}`;
}
