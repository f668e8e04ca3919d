// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";

import { Bucket, execute, freePort, Postgresql } from "./engines.mjs";

const { tocsin, folder } = JSON.parse(process.env.ARCHIVE_TEST);
const runs = path.join(folder, "runs");
let database;
let bucket;
let environment;

/** A run with two recordings. */
function makeRun(seed) {
  fs.mkdirSync(runs, { recursive: true });
  execute(tocsin, ["sim", "mission.yaml", "--seed", String(seed), "--duration", "20", "--without", "camera", "--run-dir", path.join(runs, `run${seed}`)]);
}

const archive = (words) => spawnSync(tocsin, ["archive", ...words, "--archive", "s3://recordings/site", "--index", database.url], { encoding: "utf8", env: environment });
const sync = () => archive(["sync", runs]);
const counts = () => ["files", "topics", "readings"].map((table) => Number(database.ask(`SELECT count(*) FROM ${table}`)[0][0]));

async function eventually(what, condition) {
  const end = Date.now() + 30000;
  while (!(await condition())) {
    if (Date.now() > end) throw new Error(`not within 30 s: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

before(async () => {
  database = new Postgresql(path.join(folder, "postgresql"), await freePort());
  bucket = new Bucket(path.join(folder, "s3"), await freePort(), "recordings");
  environment = { ...process.env, ...bucket.environment };
  database.start();
  await bucket.start();
  makeRun(1);
});

after(async () => {
  await bucket.stop();
  database.stop();
});

test("recordings are in bucket and index once, however often and by however many they are brought", async () => {
  const first = sync();
  assert.equal(first.status, 0, first.stderr);
  assert.match(first.stdout, /2 recordings added/);
  const known = counts();
  assert.equal(known[0], 2);
  assert.ok(known[2] > 30, "each second of both sides");
  makeRun(2);
  const many = ["sync", runs, "--archive", "s3://recordings/site", "--index", database.url];
  const atOnce = [1, 2, 3, 4].map(() => spawn(tocsin, ["archive", ...many], { env: environment, stdio: "ignore" }));
  const codes = await Promise.all(atOnce.map((one) => new Promise((resolve) => one.on("exit", resolve))));
  assert.deepEqual(codes, [0, 0, 0, 0]);
  assert.equal(counts()[0], 4);
  assert.equal((await bucket.objects()).length, 4);
  assert.match(sync().stdout, /nothing new; 4 were there/);
});

test("what comes back is what was recorded, and the index says where it is", () => {
  const said = archive(["list", "--vehicle", "uxv", "--topic", "location", "--from", "1"]);
  const lines = said.stdout.trim().split("\n");
  assert.equal(lines.length, 4, said.stderr);
  const object = lines.map((line) => line.split(" ")[0]).find((name) => name.includes("run1/uxv_"));
  const back = path.join(folder, "back.mcap");
  assert.equal(archive(["get", object, "-o", back]).status, 0);
  assert.deepEqual(fs.readFileSync(back), fs.readFileSync(path.join(runs, "run1/uxv/bag/bag_0.mcap")));
  const again = archive(["get", object, "-o", back]);
  assert.equal(again.status, 2, "never over a file that is there");
});

test("an outage of either loses nothing and doubles nothing", async () => {
  const follower = spawn(tocsin, ["archive", "sync", runs, "--follow", "0.2", "--archive", "s3://recordings/site", "--index", database.url], { env: environment });
  let said = "";
  follower.stderr.on("data", (data) => (said += data));
  try {
    database.stop();
    makeRun(3);
    await eventually("it tells of the database", () => /tocsin archive: index: /.test(said));
    database.start();
    await eventually("run 3 is indexed", () => counts()[0] === 6);
    await bucket.stop();
    makeRun(4);
    await eventually("it tells of the bucket", () => /tocsin archive: .*run4.*bucket/.test(said));
    assert.equal(counts()[0], 6, "what is not stored is not indexed");
    await bucket.start();
    await eventually("run 4 is indexed", () => counts()[0] === 8);
    assert.equal((await bucket.objects()).length, 8);
    assert.ok(said.split("\n").length < 20, "a problem that stays is told once");
  } finally {
    follower.kill("SIGTERM");
  }
  assert.match(sync().stdout, /nothing new; 8 were there/);
});

test("one that is killed goes on where it was", async () => {
  for (let seed = 5; seed < 9; ++seed) makeRun(seed);
  const words = ["archive", "sync", runs, "--archive", "s3://recordings/site", "--index", database.url];
  const killed = spawn(tocsin, words, { env: environment, stdio: "ignore" });
  await eventually("it has begun", () => counts()[0] > 8 || killed.exitCode !== null);
  killed.kill("SIGKILL");
  assert.equal(sync().status, 0);
  assert.equal(counts()[0], 16);
  const twice = database.ask("SELECT file, topic FROM topics GROUP BY file, topic HAVING count(*) > 1");
  assert.deepEqual(twice, []);
});

test("SQL answers where the link was poor, and tocsin map link makes a map of it", () => {
  const rows = database.ask("SELECT vehicle, round(x_m::numeric), count(*) FROM link_readings WHERE signal_dbm < -60 GROUP BY 1, 2 ORDER BY 2");
  assert.ok(rows.length > 0);
  const days = database.ask("SELECT tablename FROM pg_tables WHERE tablename LIKE 'readings\\_%'").flat();
  assert.deepEqual(days, ["readings_20260101"], "a table for each day");
  const file = path.join(folder, "link.csv");
  assert.equal(archive(["link", "--vehicle", "uxv", "--from", "1", "-o", file]).status, 0);
  assert.match(execute(tocsin, ["map", "link", file]), /dB/);
});
