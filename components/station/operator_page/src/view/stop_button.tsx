// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "preact/hooks";

import type { Operator } from "../operator.ts";
import { pageNow } from "../operator.ts";

/** The emergency stop, always in reach, with what the vehicle says of it. */
export function StopButton({ operator, now }: { operator: Operator; now: number }) {
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
      {kind === "stands" && (
        <button type="button" class="release" onClick={release}>
          {asks ? "Really release?" : "Release"}
        </button>
      )}
      <button
        type="button"
        class="press"
        title="Emergency stop (space bar)"
        onPointerDown={() => operator.stop.press(pageNow())}
        onClick={() => operator.stop.press(pageNow())}
      >
        STOP<kbd>space</kbd>
      </button>
    </div>
  );
}
