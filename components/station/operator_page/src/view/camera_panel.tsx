// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState } from "preact/hooks";

import { ageText } from "../model/freshness.ts";
import { camera } from "../model/messages.ts";
import { cameraLimitMs } from "../orders/control_authority.ts";
import type { Operator } from "../operator.ts";
import { Panel } from "./parts.tsx";

/** The last picture as it came, with its age over it: grey when it is too old to drive by. */
export function CameraPanel({ operator, now }: { operator: Operator; now: number }) {
  const { image, uxv } = operator.station;
  const url = usePicture(image?.value.data);
  const frame = useRef<HTMLDivElement>(null);
  const [broken, setBroken] = useState<string>();
  useEffect(() => {
    if (frame.current === null) return;
    // A picture that nobody sees need not come.
    const seen = new IntersectionObserver((entries) => {
      operator.connection.want(camera, entries.some(({ isIntersecting }) => isIntersecting));
    });
    seen.observe(frame.current);
    return () => seen.disconnect();
  }, [operator]);
  const age = image === undefined ? undefined : now - image.at;
  const isOld = age === undefined || age > cameraLimitMs;
  const paused = uxv.transmission?.value.active === false;
  return (
    <Panel name="camera" title="Camera" aside={<span class="muted">{paused ? "paused by the gate" : ""}</span>}>
      <div ref={frame} class={`picture${isOld ? " old" : ""}`}>
        {url && url !== broken && <img src={url} alt="What the vehicle sees" onError={() => setBroken(url)} />}
        {url && url === broken && <p>The picture cannot be shown ({image?.value.format}).</p>}
        {!url && <p>No picture yet</p>}
        {age !== undefined && <span class="picture-age">{isOld ? `${ageText(age)} old: do not drive by it` : ageText(age)}</span>}
      </div>
    </Panel>
  );
}

/** An address for the bytes of a picture, given back when the next one comes. */
function usePicture(data: Uint8Array | undefined): string | undefined {
  const [url, setUrl] = useState<string>();
  useEffect(() => {
    if (data === undefined) return;
    const made = URL.createObjectURL(new Blob([data as Uint8Array<ArrayBuffer>], { type: "image/jpeg" }));
    setUrl(made);
    // The one before is still on the screen until the browser has shown this one.
    return () => void setTimeout(() => URL.revokeObjectURL(made), 1000);
  }, [data]);
  return url;
}
