// SPDX-License-Identifier: Apache-2.0
// A whole mission over the emulated radio, led from the page. run.mjs starts it.
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { after, before, describe, it } from "node:test";

import { Operator, eventually, wait } from "./operator.mjs";

/** Paths of chromium, tocsin, and of a folder of the test's own. */
const options = JSON.parse(process.env.PAGE_TEST);
const here = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);
const run = path.join(options.folder, "mission");
const url = "http://127.0.0.1:8765/";

/** On a busy computer; on a quiet one at good link it is half a second. */
const mostStopMs = 10_000;

let launch;
let watcher;
let operator;
let said = "";
/** What the base does, newest last: { at [ms], x, y, speed }. */
const truth = [];

const reads = (selector, words) => operator.reads(selector, words);
const now = () => truth.at(-1) ?? { x: NaN, y: NaN, speed: NaN };

/** The vehicle's place as the page shows it. */
async function shownPlace() {
  const values = await operator.page.$$eval(".mission .value", (all) =>
    all.map((one) => [one.querySelector("dt").textContent, one.querySelector("dd").textContent]),
  );
  const [x, y] = Object.fromEntries(values).At.split(",").map(parseFloat);
  return { x, y };
}

/** What the radio between vehicle and station is from now on. */
function setRadio(...commands) {
  const done = spawnSync("python3", [path.join(here, "set_radio.py"), path.join(run, "radio.sock"), ...commands], { encoding: "utf8" });
  assert.equal(done.status, 0, done.stderr);
}

/** A value of the link panel, as a number. */
const linkValue = (name) =>
  operator.page.$$eval(".link .value", (all, wanted) => {
    const found = all.find((one) => one.querySelector("dt").textContent === wanted);
    return parseFloat(found?.querySelector("dd").textContent ?? "NaN");
  }, name);

/** Presses the space bar while the vehicle drives; how long until its wheels stand [ms]. */
async function stopBySpaceBar() {
  await eventually("a vehicle that drives", () => now().speed > 0.1);
  const pressed = Date.now();
  await operator.page.keyboard.press("Space");
  const standing = () => truth.find(({ at, speed }) => at > pressed && speed < 0.01);
  await eventually("wheels that stand", () => standing() !== undefined);
  await reads(".stop", "Vehicle confirms: stopped by station");
  return standing().at - pressed;
}

async function release() {
  await operator.press("Release");
  await operator.press("Really release?");
  await reads(".stop", "No stop stands");
}

async function isServed() {
  return fetch(url).then((answer) => answer.ok, () => false);
}

describe("Mission led from the page", { concurrency: false }, () => {
  before(async () => {
    launch = spawn(options.tocsin, ["launch", "mission.yaml", "--seed", "1", "--run-dir", run]);
    for (const stream of [launch.stdout, launch.stderr]) stream.on("data", (bytes) => (said += bytes));
    await eventually(`a page at ${url}; tocsin said: ${said}`, isServed);
    await eventually("a base", () => fs.existsSync(path.join(run, "base.sock")));
    watcher = spawn("python3", [path.join(here, "base_truth.py"), path.join(run, "base.sock")]);
    let rest = "";
    watcher.stdout.on("data", (bytes) => {
      const lines = (rest + bytes).split("\n");
      rest = lines.pop();
      for (const line of lines) {
        const [at, x, y, speed] = line.split(" ").map(Number);
        truth.push({ at: at * 1000, x, y, speed });
      }
    });
    operator = await Operator.open(url, options);
  });
  after(async () => {
    watcher?.kill();
    await operator?.close();
    launch?.kill("SIGTERM");
    await new Promise((resolve) => (launch.exitCode === null ? launch.on("exit", resolve) : resolve()));
  });

  it("shows the position within 0.2 m of the base's truth", async () => {
    await reads(".mission", "running");
    await eventually("a vehicle that drives", () => now().speed > 0.2);
    const errors = [];
    for (let i = 0; i < 15; ++i) {
      const [shown, real] = [await shownPlace(), now()];
      errors.push(Math.hypot(shown.x - real.x, shown.y - real.y));
      await wait(100);
    }
    errors.sort((a, b) => a - b);
    console.log(`position off by ${errors[7].toFixed(3)} m (median), ${errors.at(-1).toFixed(3)} m at most`);
    assert.ok(errors[7] < 0.2, `${errors[7]} m`);
  });

  it("draws the map and shows pictures and the decisions of both sides", async () => {
    await operator.until("a picture", () => document.querySelector(".picture img")?.naturalWidth > 0);
    await operator.until("a map", () => {
      const canvas = document.querySelector(".map canvas");
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size > 20;
    });
    await operator.until("both decisions", () => document.querySelectorAll(".side .gauge").length === 2);
    await reads(".traffic", "camera/image_raw/compressed");
    await operator.picture("mission", { fullPage: true });
  });

  it("stops the wheels by the space bar", async () => {
    const stood = await stopBySpaceBar();
    console.log(`wheels stand ${stood.toFixed(0)} ms after the key`);
    assert.ok(stood < mostStopMs, `${stood} ms`);
    await release();
  });

  it("stops the wheels by the space bar while 30 % of all packets are lost", async () => {
    setRadio("set mode bernoulli", "set loss 0.3");
    await eventually("a packet error rate of a bad link", async () => (await linkValue("PER")) >= 15);
    const times = [];
    for (let i = 0; i < 3; ++i) {
      times.push(await stopBySpaceBar());
      await release();
    }
    console.log(`at 30 % loss wheels stand ${times.map((one) => one.toFixed(0)).join(", ")} ms after the key`);
    assert.ok(Math.max(...times) < mostStopMs, `${times} ms`);
    setRadio("set mode radio");
  });

  it("pauses and resumes the mission", async () => {
    await operator.press("Pause");
    await reads(".mission", "mission_a: paused");
    await eventually("a vehicle that stands", () => now().speed < 0.01);
    await operator.press("Resume");
    await reads(".mission", "mission_a: running");
    await eventually("a vehicle that drives", () => now().speed > 0.1);
  });

  it("drives by hand with the keys, and stands when they are let go", async () => {
    await operator.press("Pause");
    await reads(".mission", "mission_a: paused");
    await eventually("a vehicle that stands", () => now().speed < 0.01);
    await operator.page.click(".by-sight"); // the picture may be late on a busy computer
    await operator.page.keyboard.press("m");
    await reads(".authority", "You drive");
    await operator.page.keyboard.down("s");
    await eventually("a vehicle that drives", () => now().speed > 0.1);
    await operator.page.keyboard.up("s");
    await eventually("a vehicle that stands", () => now().speed < 0.01);
    await operator.page.keyboard.press("m");
  });

  it("sends the vehicle to a place that was clicked", async () => {
    await operator.chooseGoal(0.7, 0.78);
    await operator.press("Drive there");
    await reads(".mission", "follow_waypoints: running");
    const words = await operator.page.$$eval(".entries li", (all) => all.map((one) => one.textContent));
    const [, x, y] = /goal: waypoint 1 at \((-?[\d.]+), (-?[\d.]+)\)/.exec(words.find((one) => one.includes("goal: waypoint 1 at")));
    await eventually(`a vehicle at ${x}, ${y}`, () => Math.hypot(now().x - x, now().y - y) < 0.3);
    await reads(".mission", "follow_waypoints: done");
  });

  it("shows the mission to a page that opens late", async () => {
    const late = await Operator.open(url, options);
    await late.reads(".mission", "follow_waypoints: done");
    await late.close();
  });

  it("records when it is told, and shows the recording from the station's list", async () => {
    await operator.press("Recordings");
    await reads(".recordings", "Record now");
    await operator.press("Record now");
    await reads(".recordings", "End recording");
    await reads(".recordings", "gcs/operator/bag/bag_0.mcap still being written");
    await wait(2000); // so that there is something to see
    await operator.picture("recordings");
    await operator.press("End recording");
    await reads(".recordings", "Record now");
    const line = "gcs/operator/bag/bag_0.mcap";
    await operator.until("a recording that has ended", (path) => {
      const found = [...document.querySelectorAll(".recordings li")].find((one) => one.textContent.includes(path));
      const button = found?.querySelector("button:not(:disabled)");
      button?.click();
      return button !== null && button !== undefined;
    }, line);
    await reads(".alert", `This is the recording ${line}`);
    await reads(".mission", "follow_waypoints: done");
    await operator.until("a map", () => {
      const canvas = document.querySelector(".map canvas");
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size > 20;
    });
    await operator.press("Back to the vehicle");
    await operator.until("no recording", () => document.querySelector(".replay") === null);
  });

  it("decides the last minutes again with another policy", async () => {
    await operator.page.select(".what-if select[aria-label=Policy]", "threshold");
    await operator.page.type(".what-if input", "pause_below_qni=99,resume_at_qni=100");
    await operator.press("Decide again");
    await operator.until("an answer", () => document.querySelector(".what-if p") !== null);
    const words = await operator.text(".what-if p");
    assert.match(words, /threshold pause_below_qni=99,resume_at_qni=100 would have\s+had \d+ pauses?, \d+.s silent; there were no pauses/);
    await wait(1500); // so that the plot is drawn with it
    await operator.picture("what_if", { fullPage: true });
    await operator.page.$eval(".what-if input", (input) => input.select());
    await operator.page.type(".what-if input", "alpha=much");
    await operator.press("Decide again");
    await reads(".what-if .refused", "'much' is not a number");
    operator.complaints = operator.complaints.filter((one) => !one.includes("status of 400"));
    await operator.press("Clear");
  });

  it("complains of nothing in the console", () => {
    assert.deepEqual(operator.complaints, []);
  });
});
