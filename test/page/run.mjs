// SPDX-License-Identifier: Apache-2.0
// Drives the installed page in Chromium: over a bag of a simulated mission (browser), or over a whole
// mission with the real server (mission), or measures how fast it is (measure). Without a browser: what the
// alert line says at recorded moments (moments). In place of the page: Foxglove Studio (studio). Or a page of
// two vehicles with their real servers (fleet).
// usage: node run.mjs browser|mission|fleet|measure|moments|studio --install=PREFIX [--page=FOLDER] [--pictures=FOLDER] [--gtest_output=xml:FILE]
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { run } from "node:test";
import { spec } from "node:test/reporters";
import { fileURLToPath } from "node:url";

import { collectCases, skip } from "../../components/station/operator_page/test/result_file.mjs";

const here = path.dirname(fileURLToPath(import.meta.url));
const option = (name) => process.argv.find((word) => word.startsWith(`--${name}=`))?.slice(name.length + 3);
const prefix = option("install");
const which = process.argv[2];

/** The install folder is one for all packages, or has a folder for each, or is one of these. */
function installed(name, file) {
  const places = [path.join(prefix, file), path.join(prefix, name, file), path.join(path.dirname(prefix), name, file)];
  return places.find((place) => fs.existsSync(place));
}

const chromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(fs.existsSync);
const index = option("page") ? path.join(option("page"), "index.html") : installed("operator_page", "share/operator_page/index.html");
const needsBrowser = which !== "moments";
const esbuild = path.join(here, "../../components/station/operator_page/node_modules/esbuild");
if (!needsBrowser && !fs.existsSync(esbuild)) skip("page_moments_test", "npm packages are not installed: bringup/install_packages");
if (needsBrowser && !chromium) skip(`page_${which}_test`, "chromium is not installed: bringup/install_packages --tests");
if (needsBrowser && !fs.existsSync(path.join(here, "node_modules/puppeteer-core"))) {
  skip(`page_${which}_test`, "npm packages are not installed: bringup/install_packages --tests");
}
if (needsBrowser && !index) skip(`page_${which}_test`, "the page is not built: bringup/install_packages, then bringup/build");

if (which === "studio" && !fs.existsSync(path.join(here, "studio/node_modules/@foxglove/studio-base"))) {
  skip("page_studio_test", "Foxglove Studio is not installed: npm ci --ignore-scripts in test/page/studio");
}

const bringup = installed("bringup", "share/tocsin/bringup/mission.yaml");
if (["mission", "studio"].includes(which) && !fs.readFileSync(bringup, "utf8").includes("operator_server")) {
  skip(`page_${which}_test`, "bringup/mission.yaml runs no operator_server");
}

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "page_test_"));
const tocsin = installed("tocsin_cli", "bin/tocsin");

/** The station's bag of a simulated mission. */
function makeBag() {
  const mission =
    "sim mission.yaml --seed 1 --duration 80 --set transmission_controller.policy=tocp_dsp " +
    "--set camera.in_simulated_time=drawn --run-dir";
  const made = spawnSync(tocsin, [...mission.split(" "), path.join(folder, "run")], { encoding: "utf8" });
  if (made.status !== 0) throw new Error(`tocsin ${mission}: ${made.stderr} ${made.error ?? ""}`);
  return path.join(folder, "run/gcs/bag/bag_0.mcap");
}

/** Two of the five vehicles. */
function makeFleet() {
  const file = path.join(folder, "two.yaml");
  fs.writeFileSync(file, "extends: fleet.yaml\nvehicles: {uxv2: ~, uxv4: ~, uxv5: ~}\nradio: {channel: \"${share}/config/radio/open.yaml\"}\n");
  return file;
}

process.env.PAGE_TEST = JSON.stringify({
  ...{ chromium, tocsin, folder },
  page: index && path.dirname(index),
  share: bringup && path.join(path.dirname(bringup), ".."),
  bag: ["mission", "fleet", "moments", "studio"].includes(which) ? undefined : makeBag(),
  fleet: which === "fleet" ? makeFleet() : undefined,
  map: installed("bringup", "share/tocsin/config/maps/classroom.pgm"),
  pictures: option("pictures"),
});
const tests = run({ files: [path.join(here, `${which}_test.mjs`)] });
collectCases(tests);
tests.compose(new spec()).pipe(process.stdout);
tests.on("end", () => fs.rmSync(folder, { recursive: true, force: true }));
