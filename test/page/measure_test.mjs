// SPDX-License-Identifier: Apache-2.0
// How fast the page is, with a trail of an hour: prints figures, and checks only what holds on any computer. run.mjs
// starts it: `node run.mjs measure --install=PREFIX`.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import { afterEach, describe, it } from "node:test";

import { Operator, wait } from "./operator.mjs";
import { startStandIn } from "./stand_in_server.mjs";

const options = JSON.parse(process.env.PAGE_TEST);
const [opened, frameS] = [5, 10];

let standIn;

const sorted = (values) => values.sort((a, b) => a - b);
const shares = (values) => {
  const part = (share) => values[Math.floor(share * (values.length - 1))]?.toFixed(1);
  return `median ${part(0.5)} ms, p99 ${part(0.99)} ms, most ${part(1)} ms`;
};

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

async function serve(trailS) {
  const map = { image: options.map, resolution: 0.05, x: -19, y: -8 };
  standIn = await startStandIn({ page: options.page, bag: options.bag, from: 10, map, trailS });
}

/** Notes when each frame begins and how long the page's own code works in it. */
function noteFrames() {
  const frame = window.requestAnimationFrame.bind(window);
  window.frames_ = [];
  window.requestAnimationFrame = (draw) => frame((at) => {
    const began = performance.now();
    draw(at);
    window.frames_.push({ at, work: performance.now() - began });
  });
}

/** [s] of CPU that a process and its children have used. */
function cpuS(root) {
  const stat = (pid) => fs.readFileSync(`/proc/${pid}/stat`, "utf8").replace(/.*\) /, "").split(" ");
  const all = fs.readdirSync("/proc").filter((name) => /^\d+$/.test(name)).flatMap((pid) => {
    try {
      const words = stat(pid);
      return [{ pid: Number(pid), parent: Number(words[1]), ticks: Number(words[11]) + Number(words[12]) }];
    } catch {
      return []; // it has ended
    }
  });
  const family = new Set([root]);
  for (let before = 0; before !== family.size;) {
    before = family.size;
    for (const { pid, parent } of all) if (family.has(parent)) family.add(pid);
  }
  return all.filter(({ pid }) => family.has(pid)).reduce((sum, { ticks }) => sum + ticks / 100, 0);
}

describe("How fast the page is", { concurrency: false }, () => {
  afterEach(() => standIn?.close());

  it("shows the map", async () => {
    await serve(3600);
    const times = [];
    for (let i = 0; i < opened; ++i) {
      const operator = await Operator.open("about:blank", options);
      times.push(await firstPicture(operator));
      await operator.close();
    }
    console.log(`first picture after ${times.map((one) => one.toFixed(0)).join(", ")} ms`);
    assert.ok(times.every((one) => one > 0));
  });

  for (const trailS of [0, 3600]) {
    it(`draws a trail of ${trailS} s while the vehicle drives`, async () => {
      await serve(trailS);
      const operator = await Operator.open("about:blank", options);
      await operator.page.evaluateOnNewDocument(noteFrames);
      await operator.page.goto(`http://127.0.0.1:${standIn.port}/`);
      // What happened before is told first: the trail, then the mission.
      const isTold = () => document.querySelector(".mission")?.textContent.includes("mission_a");
      await operator.page.waitForFunction(isTold, { timeout: 240_000, polling: 500 });
      await wait(5000);
      const cpu = cpuS(operator.browser.process().pid);
      await operator.page.evaluate(() => (window.frames_.length = 0));
      await wait(frameS * 1000);
      const frames = await operator.page.evaluate(() => window.frames_);
      const used = cpuS(operator.browser.process().pid) - cpu;
      const steps = sorted(frames.slice(1).map(({ at }, index) => at - frames[index].at));
      const work = sorted(frames.map(({ work }) => work).filter((one) => one > 0.1));
      const hz = (1000 * steps.length) / (frames.at(-1).at - frames[0].at);
      console.log(
        `trail of ${trailS} s: ${hz.toFixed(1)} frames a second, ${work.length} of ${frames.length} with something new; ` +
          `between two: ${shares(steps)}; own code where something is new: ${shares(work)}; ` +
          `Chromium in all: ${((100 * used) / frameS).toFixed(0)} % of a core; load ${os.loadavg()[0].toFixed(1)}`,
      );
      await operator.picture(`trail_of_${trailS}_s`);
      await operator.close();
      assert.ok(hz > 1);
    });
  }
});
