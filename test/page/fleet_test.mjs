// SPDX-License-Identifier: Apache-2.0
// Two vehicles over an emulated radio, led from one page. run.mjs starts it.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import path from "node:path";
import { after, before, describe, it } from "node:test";

import { Operator, eventually } from "./operator.mjs";

/** Paths of chromium, tocsin, and of a folder of the test's own. */
const options = JSON.parse(process.env.PAGE_TEST);
const url = (port, name = "") => `http://127.0.0.1:${port}/${name}`;
const only = ["uxv1", "uxv3"];

let launch;
let operator;
let said = "";

/** The words of a vehicle's row. */
const row = (name) =>
  operator.page.evaluate((which) => [...document.querySelectorAll(".vehicle-row")].find((one) => one.querySelector("h3").textContent === which)?.textContent ?? "", name);
const rowReads = (name, words) => eventually(`"${words}" of ${name}`, async () => (await row(name)).includes(words));

describe("A fleet led from one page", { concurrency: false }, () => {
  before(async () => {
    launch = spawn(options.tocsin, ["launch", options.fleet, "--seed", "1", "--without", "camera", "--run-dir", path.join(options.folder, "fleet")]);
    for (const stream of [launch.stdout, launch.stderr]) stream.on("data", (bytes) => (said += bytes));
    await eventually(`pages; tocsin said: ${said}`, () => Promise.all([8761, 8763].map((port) => fetch(url(port)).then(({ ok }) => ok, () => false))).then((all) => all.every(Boolean)));
    operator = await Operator.open(url(8761, "fleet.html"), options);
  });
  after(async () => {
    await operator?.close();
    launch?.kill("SIGTERM");
    await new Promise((resolve) => (launch.exitCode === null ? launch.on("exit", resolve) : resolve()));
  });

  it("shows each vehicle's own mission", async () => {
    const waypoints = async (name) => /running \d+\/(\d+)/.exec(await row(name))?.[1];
    for (const name of only) await eventually(`a mission that ${name} runs`, () => waypoints(name));
    assert.notEqual(await waypoints("uxv1"), await waypoints("uxv3"), "their missions differ");
  });

  it("tells what each uses of its share of the air", async () => {
    for (const name of only) await eventually(`the air of ${name}`, async () => /Air\d+ of \d+ %/.test(await row(name)));
  });

  it("stops the one whose button is pressed", async () => {
    await operator.page.evaluate(() => {
      [...document.querySelectorAll(".vehicle-row")].find((one) => one.querySelector("h3").textContent === "uxv3").querySelector(".press").click();
    });
    await rowReads("uxv3", "Vehicle confirms: stopped by station");
    assert.match(await row("uxv1"), /No stop stands/);
  });

  it("stops all by the space bar", async () => {
    await operator.page.keyboard.press("Space");
    for (const name of only) await rowReads(name, "Vehicle confirms: stopped by station");
  });

  it("opens the page of one, which shows and releases that one", async () => {
    await operator.page.goto(url(8763));
    await operator.reads(".connection", "uxv3");
    await operator.reads(".stop", "Vehicle confirms: stopped by station");
    await operator.reads(".mission", "running");
    await operator.press("Release");
    await operator.press("Really release?");
    await operator.reads(".stop", "No stop stands");
    await operator.page.goto(url(8761, "fleet.html"));
    await rowReads("uxv3", "No stop stands");
    await rowReads("uxv1", "Vehicle confirms: stopped by station");
  });
});
