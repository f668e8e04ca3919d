// SPDX-License-Identifier: Apache-2.0
// How fast the page is, with a trail of an hour: prints figures, and checks only what holds on any computer. run.mjs
// starts it: `node run.mjs measure --install=PREFIX`.
import assert from "node:assert/strict";
import { afterEach, beforeEach, describe, it } from "node:test";

import { Operator, wait } from "./operator.mjs";
import { startStandIn } from "./stand_in_server.mjs";

const options = JSON.parse(process.env.PAGE_TEST);
const [opened, frameS] = [5, 10];

let standIn;

/** [ms] from the beginning of the navigation until the map has been painted. */
async function firstPicture(operator) {
  await operator.page.goto(`http://127.0.0.1:${standIn.port}/`);
  await operator.until("a painted map", () => {
    const canvas = document.querySelector(".map canvas");
    if (canvas === null || canvas.width === 0) return false;
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    if (new Set(new Uint32Array(data.buffer)).size < 20) return false;
    window.paintedAt ??= performance.now();
    return true;
  });
  return operator.page.evaluate(() => window.paintedAt);
}

describe("How fast the page is", { concurrency: false }, () => {
  beforeEach(async () => {
    const map = { image: options.map, resolution: 0.05, x: -19, y: -8 };
    standIn = await startStandIn({ page: options.page, bag: options.bag, from: 10, map, trailS: 3600 });
  });
  afterEach(() => standIn?.close());

  it("shows the map", async () => {
    const times = [];
    for (let i = 0; i < opened; ++i) {
      const operator = await Operator.open("about:blank", options);
      times.push(await firstPicture(operator));
      await operator.close();
    }
    times.sort((a, b) => a - b);
    console.log(`first picture after ${times.map((one) => one.toFixed(0)).join(", ")} ms`);
    assert.ok(times.every((one) => one > 0));
  });

  it("draws a trail of an hour", async () => {
    const operator = await Operator.open(`http://127.0.0.1:${standIn.port}/`, options);
    await operator.reads(".traffic", "location");
    await wait(3000); // what happened before is told first
    const frames = await operator.page.evaluate((seconds) => new Promise((resolve) => {
      const at = [];
      const note = (now) => {
        at.push(now);
        if (now - at[0] < seconds * 1000) requestAnimationFrame(note);
        else resolve(at);
      };
      requestAnimationFrame(note);
    }), frameS);
    const steps = frames.slice(1).map((at, index) => at - frames[index]).sort((a, b) => a - b);
    const hz = (1000 * steps.length) / (frames.at(-1) - frames[0]);
    const part = (share) => steps[Math.floor(share * (steps.length - 1))].toFixed(1);
    console.log(`${hz.toFixed(1)} frames a second; between two: median ${part(0.5)} ms, p99 ${part(0.99)} ms, most ${part(1)} ms`);
    await operator.picture("trail_of_an_hour");
    await operator.close();
    assert.ok(hz > 1);
  });
});
