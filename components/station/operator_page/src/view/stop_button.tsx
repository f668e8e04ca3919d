// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "preact/hooks";

import type { EmergencyStopOrder, StopHeard } from "../orders/emergency_stop.ts";
import { pageNow } from "../page_now.ts";

/** Who can stop a vehicle. */
export interface Stopper {
  readonly stop: EmergencyStopOrder;
  readonly mayRelease: boolean;
  stopHeard(): StopHeard;
}

/** The emergency stop, always in reach, with what the vehicle says of it. `hasKey`: the space bar presses it. */
export function StopButton({ operator, now, hasKey = true }: { operator: Stopper; now: number; hasKey?: boolean }) {
  const [asks, setAsks] = useState(false);
  const { kind, text } = operator.stop.shown(operator.stopHeard(), now);
  useEffect(() => {
    if (!asks) return;
    const timer = setTimeout(() => setAsks(false), 4000);
    return () => clearTimeout(timer);
  }, [asks]);
  const release = (): void => {
    if (asks) operator.stop.release(pageNow());
    setAsks(!asks);
  };
  return (
    <div class={`stop ${kind}`}>
      <p role="status" aria-live="assertive">{text}</p>
      {kind === "stands" && operator.mayRelease && (
        <button type="button" class="release" onClick={release}>
          {asks ? "Really release?" : "Release"}
        </button>
      )}
      <button
        type="button"
        class="press"
        title={hasKey ? "Emergency stop (space bar)" : "Emergency stop of this vehicle"}
        onPointerDown={() => operator.stop.press(pageNow())}
        onClick={() => operator.stop.press(pageNow())}
      >
        STOP{hasKey && <kbd>space</kbd>}
      </button>
    </div>
  );
}
