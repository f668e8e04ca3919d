// SPDX-License-Identifier: Apache-2.0
// Foxglove Studio 1.48, as npm has it, in Chromium: on the server of a mission, and on the station's bag of it.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { after, before, describe, it } from "node:test";

import puppeteer from "puppeteer-core";

import { eventually, quiet } from "./operator.mjs";
import { serveStudio, studioPort } from "./studio_server.mjs";

const options = JSON.parse(process.env.PAGE_TEST);
const run = path.join(options.folder, "studio");
const server = "127.0.0.1:8765";
/** The software renderer draws without a graphics card. */
const drawn = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];

let launch;
let studio;
let browser;
let page;
let said = "";

const text = () => page.evaluate(() => document.body.innerText);
const reads = async (what, pattern) => {
  let seen = "";
  await eventually(`${what} in Studio`, async () => pattern.test((seen = await text()))).catch((error) => {
    throw new Error(`${error.message}; it reads: ${seen.slice(0, 2000)}`);
  });
};
/** The tab has the number of problems behind its name. */
const problems = () => page.$$eval("button[role=tab]", (tabs) => tabs.map((tab) => tab.textContent).find((one) => one.startsWith("Problems")));

async function open(source) {
  page = await browser.newPage();
  await page.setViewport({ width: 1500, height: 950 });
  await page.goto(`http://localhost:${studioPort}/?${new URLSearchParams(source)}`);
}

async function picture(name) {
  if (options.pictures) await page.screenshot({ path: path.join(options.pictures, `${name}.png`) });
}

/** A canvas with something on it takes many more bytes than an even one. */
async function isDrawn(panel) {
  const canvas = await page.$(`[data-testid^="panel-mouseenter-container ${panel}"] canvas`);
  return canvas !== null && (await canvas.screenshot()).length > 8000;
}

describe("Foxglove Studio", { concurrency: false }, () => {
  before(async () => {
    launch = spawn(options.tocsin, ["launch", "mission.yaml", "--seed", "1", "--run-dir", run]);
    for (const stream of [launch.stdout, launch.stderr]) stream.on("data", (bytes) => (said += bytes));
    studio = await serveStudio(path.join(options.share, "config/layouts/mission.json"), () => path.join(run, "gcs/bag/bag_0.mcap"));
    await eventually(`a server; tocsin said: ${said}`, () => fetch(`http://${server}/`).then(({ ok }) => ok, () => false));
    browser = await puppeteer.launch({ executablePath: options.chromium, args: [...quiet, ...drawn] });
    await open({ ds: "foxglove-websocket", "ds.url": `ws://${server}` });
  });
  after(async () => {
    await browser?.close();
    launch?.kill("SIGTERM");
    studio?.close();
  });

  it("connects by default, and lists no problem", async () => {
    await reads("the server's name", /Tocsin[\s\S]*DURATION/);
    await reads("messages", /\/location[\s\S]*Hz/);
    assert.equal(await problems(), "Problems");
  });
  it("begins its time axis with the station's clock, not with 1970", async () => {
    const duration = /DURATION\s+(\d+):(\d+):/.exec(await text());
    assert.ok(duration && Number(duration[1]) === 0 && Number(duration[2]) < 10, String(duration));
  });
  it("draws map and camera of the shipped layout, all of whose panels it knows", async () => {
    await eventually("a map", () => isDrawn("3D!map"));
    await eventually("a picture of the camera", () => isDrawn("ImageViewPanel!camera"));
    assert.doesNotMatch(await text(), /Unknown panel type/);
    await picture("studio_live");
  });
  it("opens the station's bag, which has map, frames, diagnostics and log", async () => {
    await page.close();
    const isRecorded = (topic) => fs.existsSync(path.join(run, "gcs", `${topic}.csv`));
    const topics = ["map", "tf", "diagnostics", "rosout"];
    await eventually("messages of each", () => topics.every(isRecorded));
    launch.kill("SIGTERM");
    await new Promise((resolve) => (launch.exitCode === null ? launch.on("exit", resolve) : resolve()));
    await open({ ds: "remote-file", "ds.url": `http://localhost:${studioPort}/bag.mcap` });
    await reads("the bag's topics", /\/location/);
    await page.type("input[placeholder^='Filter']", "/");
    for (const topic of topics) await reads(topic, new RegExp(`/${topic}\\n`));
    assert.equal(await problems(), "Problems");
    // The map may have come into the bag a moment after its first message: it is played.
    await page.evaluate(() => document.activeElement?.blur());
    await page.keyboard.press("Space");
    await eventually("a map", () => isDrawn("3D!map"));
    await picture("studio_bag");
  });
});
