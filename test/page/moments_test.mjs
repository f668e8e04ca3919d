// SPDX-License-Identifier: Apache-2.0
// The alert line at 200 recorded moments of Mission B, and as many of pages that were just opened.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { before, describe, it } from "node:test";

import { alertAt, pageModel, readBag, truthAt } from "./moments.mjs";

const { tocsin, folder, share } = JSON.parse(process.env.PAGE_TEST);
const momentsOfARun = 100;
/** What has happened within this time the station cannot know yet: the vehicle measures once a second. */
const measuredMs = 1000;
const faults = `faults:
  - {kind: loss, at_s: 55, for_s: 20, target: radio, amount: 0.48}
  - {kind: delay, at_s: 95, for_s: 12, target: radio, amount: 4}
  - {kind: stop, at_s: 120, for_s: 8, target: gcs, amount: 0}
`;

/** What both sides recorded of a simulated Mission B. */
async function recorded(model, radio) {
  const run = path.join(folder, radio);
  const file = path.join(folder, `${radio}.faults.yaml`);
  fs.writeFileSync(file, faults);
  const made = spawnSync(tocsin, ["sim", "mission.yaml", "--seed", "3", "--duration", "170",
    "--channel", path.join(share, `config/radio/${radio}.yaml`), "--faults", file,
    "--set", `mission_control.mission_file=${path.join(share, "config/missions/mission_b.yaml")}`,
    "--set", "transmission_controller.policy=tocp_dsp", "--run-dir", run], { encoding: "utf8" });
  assert.equal(made.status, 0, `${made.stderr} ${made.error ?? ""}`);
  const [station, vehicle] = await Promise.all(
    ["gcs", "uxv"].map((host) => readBag(model, path.join(run, host, "bag/bag_0.mcap"))));
  return { station, vehicle };
}

describe("The alert line at 200 recorded moments of Mission B", () => {
  const moments = [];
  before(async () => {
    const model = await pageModel(folder);
    for (const radio of ["thesis_b", "weak_b"]) {
      const bags = await recorded(model, radio);
      const [first, last] = [bags.station[0].at, bags.station.at(-1).at];
      for (let i = 0; i < momentsOfARun; ++i) {
        const now = first + ((i + 0.5) * (last - first)) / momentsOfARun;
        const opened = now - 500 - 250 * (i % 20);
        // The measurement a second before, the last one, and the next, which tells of this moment itself.
        const truth = {
          told: truthAt(model, bags, now - measuredMs),
          last: truthAt(model, bags, now),
          now: truthAt(model, bags, now, true),
        };
        const said = { page: alertAt(model, bags.station, first, now), fresh: alertAt(model, bags.station, opened, now) };
        moments.push({ radio, at: (now - first) / 1000, truth, ...said });
      }
    }
  });
  const saysWell = ({ page, fresh }) => [page, fresh].some(({ severity }) => severity === "well");
  const shown = ({ radio, at, truth, page, fresh }) => `${radio} ${at.toFixed(1)} s, ${truth.now.word}: ${page.text} | ${fresh.text}`;

  it("says well nowhere where the link was below good for a second, or the vehicle was hindered", () => {
    const isBad = (truth) =>
      Object.values(truth).every(({ isGood }) => !isGood) || Object.values(truth).every(({ hindered }) => hindered.length > 0);
    const bad = moments.filter(({ truth }) => isBad(truth));
    assert.ok(bad.length >= 60, `only ${bad.length} moments are bad`);
    assert.deepEqual(bad.filter(saysWell).map(shown), []);
  });
  it("says well too long by no more than the second that a measurement takes", () => {
    const turned = moments.filter(({ truth }) => truth.told.isWell && !truth.now.isWell);
    assert.ok(turned.length <= 0.1 * moments.length, turned.map(shown).join("\n"));
  });
  it("says well where link and vehicle are well, to a page that has listened for two seconds", () => {
    const good = moments.filter(({ truth }) => truth.told.isWell && truth.now.isWell);
    const well = good.filter(({ page }) => page.severity === "well");
    assert.ok(good.length >= 60, `only ${good.length} moments are good`);
    assert.ok(well.length >= 0.7 * good.length, good.filter((one) => !well.includes(one)).map(shown).join("\n"));
  });
  it("names the safety that hinders in each moment in which it does", () => {
    const hindered = moments.filter(({ truth }) => truth.told.hindered.length > 0 && truth.now.hindered.length > 0);
    assert.ok(hindered.length >= 6, `only ${hindered.length} moments are hindered`);
    for (const one of hindered) assert.match(one.page.text, /emergency stop/, shown(one));
  });
});
