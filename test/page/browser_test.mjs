// SPDX-License-Identifier: Apache-2.0
// Drives the page in Chromium, as an operator does, against the stand-in server. run.mjs starts it.
import assert from "node:assert/strict";
import { once } from "node:events";
import net from "node:net";
import { after, afterEach, before, describe, it } from "node:test";

import { Operator, eventually, wait } from "./operator.mjs";
import { startStandIn } from "./stand_in_server.mjs";

/** Paths of chromium, page, bag and map, and of a folder for pictures, which may be undefined. */
const options = JSON.parse(process.env.PAGE_TEST);
const sizes = [[1280, 900], [820, 1180], [390, 844]];
const tabs = ["Map", "Drive", "Link", "Topics", "Vehicle"];

let standIn;
let operator;
let page;

async function startServer(port = 0, from = 36) {
  const map = { image: options.map, resolution: 0.05, x: -19, y: -8 };
  standIn = await startStandIn({ page: options.page, bag: options.bag, from, port, map });
}

const reads = (selector, words) => operator.reads(selector, words);
const until = (what, look) => operator.until(what, look);
const press = (label) => operator.press(label);
const commands = (topic) => standIn.state.commands.filter((one) => one.topic === topic);

/** Panels and controls that lie over each other or beyond the edge. */
const misplaced = () => {
  const found = [];
  const seen = (selector) => [...document.querySelectorAll(selector)].filter((one) => one.offsetParent || one.getClientRects().length);
  const name = (one) => one.className || one.textContent.slice(0, 20);
  const box = (one) => one.getBoundingClientRect();
  const over = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1;
  for (const group of [".panel", ".buttons > *", ".drive-body > *", ".value", ".side"]) {
    const all = seen(group);
    all.forEach((a, index) => {
      for (const b of all.slice(index + 1)) if (over(box(a), box(b))) found.push(`${name(a)} over ${name(b)}`);
    });
  }
  for (const one of seen("button, .panel, .stop, .value")) {
    const { left, right } = box(one);
    if (left < -1 || right > innerWidth + 1) found.push(`${name(one)} beyond the edge`);
  }
  if (document.documentElement.scrollWidth > innerWidth) found.push("the page is wider than the window");
  return found;
};

describe("Page in Chromium", { concurrency: false }, () => {
  before(async () => {
    await startServer();
    operator = await Operator.open(`http://127.0.0.1:${standIn.port}/`, options);
    page = operator.page;
  });
  after(async () => {
    await operator?.close();
    standIn?.close();
  });

  it("shows the mission that it hears", async () => {
    await reads(".connection", "connected");
    await reads(".mission", "mission_a");
    await reads(".link", "tocp_dsp");
    await reads(".traffic", "location");
    await reads(".vehicle", "nothing hinders");
    const cells = () => [...document.querySelectorAll(".stored tbody tr")].map((one) => [...one.children].map((cell) => cell.textContent).join(" "));
    await until("a stored topic", () => document.querySelector(".stored tbody tr") !== null);
    assert.deepEqual(await page.evaluate(cells), ["battery_state 120 30 4 2"]);
    const painted = await page.$eval(".map canvas", (canvas) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size;
    });
    assert.ok(painted > 20, `the map has ${painted} colours`);
  });

  it("stops by the space bar, wherever the focus is, and shows the vehicle's confirmation", async () => {
    await page.focus(".tools button");
    await page.keyboard.press("Space");
    await reads(".stop", "Vehicle confirms: stopped by station");
    const [first] = commands("/emergency_stop/request");
    assert.equal(first.message.data, true);
    await reads(".alert", "The vehicle stands: emergency stop of station");
  });

  it("releases only when it is asked twice", async () => {
    await press("Release");
    await reads(".stop", "Really release?");
    assert.ok(commands("/emergency_stop/request").every(({ message }) => message.data));
    await press("Really release?");
    await eventually("a release", () => commands("/emergency_stop/request").at(-1).message.data === false);
    await reads(".stop", "No stop stands");
  });

  it("says what has not answered when nothing confirms a stop", async () => {
    standIn.state.silent = true;
    await page.keyboard.press("Space");
    await reads(".stop", "the station has not answered");
    standIn.state.silent = false;
    await reads(".stop", "Vehicle confirms");
    await press("Release");
    await press("Really release?");
    await reads(".stop", "No stop stands");
  });

  it("drives by held keys after control was taken, and stops at release", async () => {
    await page.click(".by-sight"); // sees the vehicle itself: the camera is paused
    await page.keyboard.down("w");
    await wait(200);
    await page.keyboard.up("w");
    assert.equal(commands("/teleop/cmd_vel").length, 0, "nobody had taken control");
    await page.keyboard.press("m");
    await reads(".authority", "You drive");
    await page.keyboard.down("w");
    await eventually("three commands", () => commands("/teleop/cmd_vel").length >= 3);
    await page.keyboard.up("w");
    await eventually("three zeros", () => commands("/teleop/cmd_vel").slice(-3).every(({ message }) => message.twist.linear.x === 0));
    assert.equal(commands("/teleop/cmd_vel")[0].message.twist.linear.x, 0.2);
    const count = commands("/teleop/cmd_vel").length;
    await wait(400);
    assert.equal(commands("/teleop/cmd_vel").length, count, "silent afterwards");
    await page.keyboard.press("m");
  });

  it("does not drive by an old picture", async () => {
    await page.click(".by-sight");
    await until("a picture", () => document.querySelector(".picture img") !== null);
    standIn.state.withoutImages = true;
    await page.keyboard.press("m");
    await reads(".authority", "Not by hand now: the picture is ");
    const count = commands("/teleop/cmd_vel").length;
    await page.keyboard.down("w");
    await wait(300);
    await page.keyboard.up("w");
    assert.equal(commands("/teleop/cmd_vel").length, count);
    await page.keyboard.press("m");
    standIn.state.withoutImages = false;
  });

  it("hands a place that is chosen by click and drag to mission_control as a mission", async () => {
    await operator.chooseGoal(0.02, 0.5);
    await reads(".mission-bar", "in a wall or beyond the map");
    await press("Leave");
    await operator.chooseGoal(0.7, 0.78); // in the classroom
    await operator.picture("goal");
    await press("Drive there");
    await eventually("a mission", () => commands("send_goal").length > 0);
    const { poses } = commands("send_goal")[0].message.goal;
    assert.equal(poses.length, 1);
    const { z, w } = poses[0].pose.orientation;
    assert.ok(Math.abs(2 * Math.atan2(z, w) - Math.PI / 2) < 0.05, `heading ${2 * Math.atan2(z, w)}`);
    assert.equal(commands("/goal").length + commands("/mission/command").length, 0, "mission_control alone leads");
    await reads(".mission", "Mission accepted");
    await reads(".mission", "follow_waypoints: running");
    await reads(".mission", "1 of 1");
    await press("Pause");
    await reads(".mission", "follow_waypoints: paused");
    await press("Resume");
    await reads(".mission", "follow_waypoints: running");
    await press("Cancel mission");
    await reads(".mission", "follow_waypoints: aborted");
  });

  it("edits a mission on the map: add, move, reorder, remove; sends it as one", async () => {
    const sent = commands("send_goal").length;
    await press("Mission");
    await reads(".mission-bar", "Press on the map");
    for (const [across, down] of [[0.7, 0.78], [0.74, 0.78], [0.78, 0.78]]) {
      const { x, y } = await operator.onMap(across, down);
      await page.mouse.click(x, y);
    }
    await reads(".mission-bar", "Place 3 of 3");
    const [from, to] = [await operator.onMap(0.74, 0.78), await operator.onMap(0.74, 0.82)];
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 3 });
    await page.mouse.up();
    await reads(".mission-bar", "Place 2 of 3");
    await page.click("button[title^='Later in the order']");
    await reads(".mission-bar", "Place 3 of 3");
    await wait(300);
    await operator.picture("mission_edit");
    await page.keyboard.press(",");
    await page.keyboard.press("Delete"); // the one that was third
    await reads(".mission-bar", "of 2");
    await page.keyboard.press("Insert");
    await reads(".mission-bar", "of 3");
    await page.keyboard.press("Delete");
    await page.keyboard.press("Enter");
    await eventually("a mission", () => commands("send_goal").length > sent);
    const { poses } = commands("send_goal").at(-1).message.goal;
    assert.equal(poses.length, 2);
    const [first, second] = poses.map(({ pose }) => pose.position);
    assert.ok(second.y < first.y - 0.05 && second.x > first.x, "the moved one is the last");
    await reads(".mission", "1 of 2");
  });

  it("keeps a draft that is rejected, and says why", async () => {
    standIn.state.refusal = "waypoint 1 is nearer to a wall than 0.18 m";
    await operator.chooseGoal(0.7, 0.78);
    await press("Drive there");
    await reads(".mission .refused", standIn.state.refusal);
    await reads(".mission-bar", `Place 1 of 1. Refused: ${standIn.state.refusal}`);
    standIn.state.refusal = "";
    await press("Drive there");
    await reads(".mission", "Mission accepted");
    await until("no draft", () => document.querySelector(".mission-bar") === null);
  });

  it("edits by fingers: a tap adds, a drag moves, two fingers edit nothing", async () => {
    const touch = await page.createCDPSession();
    const send = (type, ...touchPoints) => touch.send("Input.dispatchTouchEvent", { type, touchPoints });
    const point = async (across, down, id = 0) => ({ ...(await operator.onMap(across, down)), id });
    await press("Mission");
    await reads(".mission-bar", "Press on the map");
    await send("touchStart", await point(0.7, 0.78));
    await send("touchEnd");
    await reads(".mission-bar", "Place 1 of 1");
    await send("touchStart", await point(0.76, 0.78));
    await send("touchStart", await point(0.76, 0.78), await point(0.8, 0.85, 1));
    await send("touchEnd");
    await reads(".mission-bar", "Place 1 of 1");
    await press("Leave");
    await touch.detach();
  });

  it("shows another page, and one that is loaded anew, the same mission", async () => {
    const other = await Operator.open(`http://127.0.0.1:${standIn.port}/`, options);
    await other.reads(".mission", "follow_waypoints: running");
    await other.press("Cancel mission");
    await other.close();
    await reads(".mission", "follow_waypoints: aborted");
    await page.reload();
    await reads(".mission", "follow_waypoints: aborted");
  });

  it("shows strip, mission buttons and link without scrolling at 1280 x 800", async () => {
    await page.setViewport({ width: 1280, height: 800 });
    await wait(300);
    await page.evaluate(() => scrollTo(0, 0));
    await reads(".strip", "PER");
    const wanted = [".strip dd", ".mission button", ".link .value", ".link .side h3", ".link .gauge"];
    const below = (selectors) => selectors.flatMap((one) => [...document.querySelectorAll(one)])
      .filter((one) => one.getBoundingClientRect().bottom > innerHeight).map((one) => one.textContent);
    assert.deepEqual(await page.evaluate(below, wanted), []);
    await operator.picture("page_1280x800");
  });
  for (const [width, height] of sizes) {
    it(`fits a window of ${width} px`, async () => {
      await page.setViewport({ width, height });
      await wait(300);
      for (const tab of width < 700 ? tabs : [""]) {
        if (tab) await press(tab);
        await wait(150);
        assert.deepEqual(await page.evaluate(misplaced), [], tab);
        const stop = await (await page.$(".stop .press")).boundingBox();
        assert.ok(stop.y >= 0 && stop.y + stop.height <= height, "the stop is in reach");
        await operator.picture(`page_${width}${tab && "_"}${tab.toLowerCase()}`, { fullPage: !tab });
      }
      if (width < 700) await press("Map");
      await press("Recordings");
      await reads(".recordings", "still being written");
      assert.deepEqual(await page.evaluate(misplaced), [], "recordings");
      await operator.picture(`recordings_${width}`);
      await press("Close");
    });
  }

  it("keeps the last position as a ghost and says once that the vehicle is not heard", async () => {
    await page.setViewport({ width: 1280, height: 900 });
    standIn.state.withoutVehicle = true;
    await reads(".alert", "The vehicle was last heard");
    assert.equal((await page.$$(".alert")).length, 1);
    await until("a stale value", () => document.querySelector(".mission .stale .age") !== null);
    await operator.picture("lost");
    standIn.state.withoutVehicle = false;
    await until("no alert of silence", () => !document.querySelector(".alert").textContent.includes("last heard"));
  });

  it("comes back by itself after the server was gone", async () => {
    const { port, playedS } = standIn;
    standIn.close();
    await reads(".alert", "No connection to the station");
    await reads(".connection", "not connected");
    await startServer(port, playedS()); // clocks do not go back
    await reads(".connection", "connected");
    await until("fresh values", () => document.querySelector(".mission .fresh") !== null);
    operator.complaints = operator.complaints.filter((one) => !/WebSocket connection|ERR_CONNECTION/.test(one));
  });

  it("asks for control while another drives, gets it, and is asked for it", async () => {
    standIn.sayDriver("page_other");
    await reads(".authority", "page_other drives");
    await press("Ask for control");
    await eventually("a request", () => commands("/teleop/request").at(-1)?.message.verb === "ask");
    const me = commands("/teleop/request").at(-1).message.name;
    standIn.sayDriver("page_other", me);
    await reads(".authority", "page_other was asked for control");
    standIn.sayDriver(me);
    await reads(".drive button", "Let go");
    standIn.sayDriver(me, "page_other");
    await reads(".authority", "page_other asks for control");
    await press("Keep it");
    await eventually("keep", () => commands("/teleop/request").at(-1).message.verb === "keep");
    standIn.sayDriver("page_other");
    await reads(".authority", "page_other has taken over");
    standIn.sayDriver("");
    await reads(".drive button", "Take control");
  });

  it("sends no mission while another drives by hand, or without a place", async () => {
    const count = commands("send_goal").length;
    await press("Mission");
    await reads(".mission-bar", "Press on the map");
    await page.keyboard.press("Enter");
    const { x, y } = await operator.onMap(0.7, 0.78);
    await page.mouse.click(x, y);
    standIn.sayDriver("page_other");
    await reads(".mission-bar", "page_other drives by hand");
    await page.keyboard.press("Enter");
    standIn.sayDriver("");
    await reads(".mission-bar", "Place 1 of 1");
    await page.keyboard.press("Escape");
    assert.equal(commands("send_goal").length, count);
  });

  it("plays a recording in place of the vehicle, and stops the vehicle all the same", async () => {
    await press("Recordings");
    const input = await page.waitForSelector(".open-bag input");
    await input.uploadFile(options.bag);
    await reads(".alert", "This is the recording");
    await page.click(".replay button"); // pause
    await reads(".replay button", "Play");
    await page.$eval(".replay input", (slider) => {
      slider.value = "30";
      slider.dispatchEvent(new Event("input", { bubbles: true }));
    });
    await reads(".replay .position", "0:30 of");
    await reads(".mission", "4 of 9");
    await reads(".authority", "a recording is shown");
    await operator.picture("replay");
    standIn.state.commands.length = 0;
    await page.keyboard.press("Space");
    await reads(".stop", "Vehicle confirms");
    await press("Back to the vehicle");
    await until("no recording", () => document.querySelector(".replay") === null);
  });

  it("complains of nothing in the console", () => {
    assert.deepEqual(operator.complaints, []);
  });
});

async function freePort() {
  const server = net.createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = server.address();
  server.close();
  await once(server, "close");
  return port;
}

describe("The page of a supervisor and of an observer", { concurrency: false }, () => {
  let server;
  let person;
  const open = async (role) => {
    const map = { image: options.map, resolution: 0.05, x: -19, y: -8 };
    server = await startStandIn({ page: options.page, bag: options.bag, from: 36, port: await freePort(), map, about: { role } });
    person = await Operator.open(`http://127.0.0.1:${server.port}/?name=anna`, options);
    await person.reads(".connection", `connected, ${role}`);
    server.sayDriver("ben");
    await person.reads(".authority", "ben drives");
  };
  afterEach(async () => {
    await person?.close();
    server?.close();
  });
  const requests = () => server.state.commands.filter(({ topic }) => topic === "/teleop/request");

  it("takes control over at once, under the name of its link", async () => {
    await open("supervisor");
    await person.picture("supervisor");
    await person.press("Take over");
    await eventually("a request", () => requests().at(-1)?.message.verb === "take");
    assert.equal(requests().at(-1).message.name, "anna");
    server.sayDriver("anna");
    await person.reads(".drive button", "Let go");
  });

  it("lets an observer press the stop, and nothing else", async () => {
    await open("observer");
    await person.picture("observer");
    const enabled = await person.page.$$eval(".drive .buttons button, .mission .buttons button", (all) => all.filter((one) => !one.disabled).length);
    assert.equal(enabled, 0);
    await person.press("STOP");
    await eventually("a stop", () => server.state.commands.some(({ topic, message }) => topic === "/emergency_stop/request" && message.data));
    await person.until("no release", () => document.querySelector(".stop.stands") !== null && document.querySelector(".release") === null);
    assert.deepEqual(requests(), []);
  });
});

describe("Fleet page in Chromium", { concurrency: false }, () => {
  let servers;
  let person;
  /** As they stand on the page, from above. */
  const rows = () =>
    person.page.$$eval(".vehicle-row", (all) => {
      const top = (one) => one.getBoundingClientRect().top;
      return all.sort((a, b) => top(a) - top(b)).map((one) => [one.querySelector("h3").textContent, one.className]);
    });
  const stops = (server) => server.state.commands.filter(({ topic, message }) => topic === "/emergency_stop/request" && message.data);

  before(async () => {
    const ports = [await freePort(), await freePort()];
    const fleet = ports.map((port, index) => `uxv${index + 1}=http://127.0.0.1:${port}/`).join(" ");
    const map = { image: options.map, resolution: 0.05, x: -19, y: -8 };
    servers = await Promise.all(ports.map((port, index) =>
      startStandIn({ page: options.page, bag: options.bag, from: 36, port, map, about: { vehicle: `uxv${index + 1}`, fleet } })));
    person = await Operator.open(`http://127.0.0.1:${ports[0]}/fleet.html`, options);
  });
  after(async () => {
    await person?.close();
    for (const server of servers ?? []) server.close();
  });

  it("shows all vehicles in a list and on the map", async () => {
    await person.until("two missions", () => {
      const all = [...document.querySelectorAll(".vehicle-row")];
      return all.length === 2 && all.every((one) => one.textContent.includes("running"));
    });
    const painted = await person.page.$eval(".map canvas", (canvas) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size;
    });
    assert.ok(painted > 10, `the map has ${painted} colours`);
    assert.equal(await person.page.$eval(".vehicle-row a", (link) => new URL(link.href).pathname), "/");
  });

  it("stops one, which comes first then, and tells that in the alarms", async () => {
    await person.page.evaluate(() => {
      [...document.querySelectorAll(".vehicle-row")].find((one) => one.textContent.startsWith("uxv2")).querySelector(".press").click();
    });
    await person.reads(".vehicle-row.is-error", "uxv2");
    assert.deepEqual((await rows())[0], ["uxv2", "vehicle-row is-error"]);
    assert.equal(stops(servers[0]).length, 0);
    await person.reads(".alarm.is-error", "The vehicle stands: emergency stop of station");
    if (options.pictures) await person.page.screenshot({ path: `${options.pictures}/fleet.png` });
    await person.page.click(".alarm.is-error button");
    await person.reads(".alarm.is-known", "uxv2");
  });

  it("stops all by the space bar", async () => {
    await person.page.keyboard.press("Space");
    await eventually("a stop of both", () => servers.every((server) => stops(server).length > 0));
    await person.until("both stand", () => document.querySelectorAll(".vehicle-row .stop.stands").length === 2);
  });

  it("tells of a vehicle whose server is gone", async () => {
    servers[1].close();
    await person.until("no connection", () => {
      const row = [...document.querySelectorAll(".vehicle-row")].find((one) => one.textContent.startsWith("uxv2"));
      return row?.textContent.includes("No connection to the station");
    });
    assert.equal((await rows())[0][0], "uxv2");
  });

  it("is reached from a vehicle's page", async () => {
    await person.page.goto(`http://127.0.0.1:${servers[0].port}/`);
    await person.reads(".brand a", "fleet");
    assert.equal(await person.page.$eval(".brand a", (link) => new URL(link.href).pathname), "/fleet.html");
  });

  it("is as wide as a phone", async () => {
    await person.page.goto(`http://127.0.0.1:${servers[0].port}/fleet.html`);
    await person.until("the list", () => document.querySelectorAll(".vehicle-row").length === 2);
    for (const [width, height] of sizes) {
      await person.page.setViewport({ width, height });
      await wait(300);
      assert.deepEqual(await person.page.evaluate(misplaced), [], `${width} x ${height}`);
      const hidden = () => [".vehicle-row .press", ".panel.alarms", ".map canvas", ".top .press"].filter((one) => !document.querySelector(one)?.getClientRects().length);
      assert.deepEqual(await person.page.evaluate(hidden), [], `${width} x ${height}`);
      if (options.pictures) await person.page.screenshot({ path: `${options.pictures}/fleet_${width}.png`, fullPage: true });
    }
  });
});
