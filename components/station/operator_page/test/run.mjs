// SPDX-License-Identifier: Apache-2.0
// Checks the types (tsc) and runs test/*.test.ts with node's test runner:
// `node run.mjs [--gtest_output=xml:FILE]`. Without npm's packages one case is skipped, with the reason.
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { run } from "node:test";
import { spec } from "node:test/reporters";
import { fileURLToPath } from "node:url";

import { takeIdlTypes } from "../idl_types.mjs";
import { collectCases, skip } from "./result_file.mjs";

const here = path.dirname(fileURLToPath(import.meta.url));

function checkTypes() {
  const package_ = path.join(here, "..");
  const done = spawnSync(path.join(package_, "node_modules/.bin/tsc"), { cwd: package_, encoding: "utf8" });
  if (done.status !== 0) console.log(done.stdout, done.error ?? "");
  return { name: "tsc finds nothing wrong", failed: done.status !== 0 };
}

let esbuild;
try {
  esbuild = await import("esbuild");
} catch {
  skip("operator_page", "the page's npm packages are not installed: bringup/install_packages");
}

takeIdlTypes();
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "operator_page_test_"));
const names = fs.readdirSync(here).filter((name) => name.endsWith(".test.ts"));
await esbuild.build({
  entryPoints: names.map((name) => path.join(here, name)),
  outdir: folder,
  outExtension: { ".js": ".mjs" },
  bundle: true,
  platform: "node",
  format: "esm",
  // There are CommonJS packages among the bundled ones.
  banner: { js: "import { createRequire } from 'node:module'; const require = createRequire(import.meta.url);" },
  define: { "import.meta.dirname": JSON.stringify(here) },
  logLevel: "warning",
});
const files = names.map((name) => path.join(folder, name.replace(/\.ts$/, ".mjs")));
const tests = run({ files, concurrency: 2 });
collectCases(tests, [checkTypes()]);
tests.compose(new spec()).pipe(process.stdout);
tests.on("end", () => fs.rmSync(folder, { recursive: true }));
