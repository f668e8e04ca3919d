// SPDX-License-Identifier: Apache-2.0
// An operator before the page: a Chromium with what people do and read.
import assert from "node:assert/strict";
import path from "node:path";

import puppeteer from "puppeteer-core";

export const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** Far more than anything takes: tests also run on computers that are busy with something else. */
const patienceMs = 60_000;

/** Waits until `look` is true; says what it waited for. */
export async function eventually(what, look, limitMs = patienceMs) {
  const end = Date.now() + limitMs;
  while (Date.now() < end) {
    if (await look()) return;
    await wait(50);
  }
  assert.fail(`never: ${what}`);
}

/** As root, and without a word to anybody outside of this computer. */
export const quiet = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync",
  "--disable-background-networking", "--disable-component-update"];

export class Operator {
  /** Errors that the page has written to its console. */
  complaints = [];

  /** `pictures`: a folder for screenshots; undefined: none are taken. */
  static async open(url, { chromium, pictures }) {
    const operator = new Operator();
    operator.pictures = pictures;
    operator.browser = await puppeteer.launch({ executablePath: chromium, args: quiet });
    const page = await operator.browser.newPage();
    operator.page = page;
    await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
    page.on("console", (message) => {
      if (message.type() === "error") operator.complaints.push(message.text());
    });
    page.on("pageerror", (error) => operator.complaints.push(error.message));
    await page.setViewport({ width: 1280, height: 900 });
    await page.goto(url);
    return operator;
  }

  close() {
    return this.browser.close();
  }

  /** Waits until `look`, evaluated in the page, is true. */
  async until(what, look, ...args) {
    const options = { timeout: patienceMs, polling: 50 };
    await this.page.waitForFunction(look, options, ...args).catch(() => assert.fail(`never: ${what}`));
  }

  /** Waits until the first element of that kind has these words. */
  reads(selector, words) {
    const look = (where, what) => document.querySelector(where)?.textContent.includes(what);
    return this.until(`"${words}" in ${selector}`, look, selector, words);
  }

  text(selector) {
    return this.page.$eval(selector, (element) => element.textContent);
  }

  /** Presses the first button whose words begin so. */
  press(label) {
    return this.page.evaluate((what) => {
      [...document.querySelectorAll("button")].find((one) => one.textContent.startsWith(what)).click();
    }, label);
  }

  /** Chooses a goal at a share of the map's width and height, heading up. */
  async chooseGoal(across, down) {
    await this.press("Mission");
    await this.until("a bar of the mission", () => document.querySelector(".mission-bar") !== null);
    const { x, y } = await this.onMap(across, down);
    await this.page.mouse.move(x, y);
    await this.page.mouse.down();
    await this.page.mouse.move(x, y - 60);
    await this.page.mouse.up();
  }

  /** The pixel at a share of the map's width and height. */
  async onMap(across, down) {
    const box = await (await this.page.$(".map canvas")).boundingBox();
    return { x: box.x + across * box.width, y: box.y + down * box.height };
  }

  async picture(name, options = {}) {
    if (this.pictures) await this.page.screenshot({ path: path.join(this.pictures, `${name}.png`), ...options });
  }
}
