// SPDX-License-Identifier: Apache-2.0
// Checks the types (tsc) and runs test/*.test.ts with node's test runner: `node run.mjs [--gtest_output=xml:FILE]`. The file is
// as GoogleTest's, so that test/run_tests.py counts the cases. Without npm's packages one case is
// skipped, with the reason.
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { run } from "node:test";
import { spec } from "node:test/reporters";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const file = process.argv.find((word) => word.startsWith("--gtest_output=xml:"))?.split("xml:")[1];
const escaped = (text) => text.replace(/[^\w .,:;()/'-]/g, (one) => `&#${one.codePointAt(0)};`);

/** Cases are { name, failure, skipped }, the last two undefined or a text. */
function writeResult(cases) {
  if (!file) return;
  const line = ({ name, failure, skipped }) => {
    const inside = failure !== undefined ? "<failure/>" : skipped ? `<skipped message="${escaped(skipped)}"/>` : "";
    return `<testcase name="${escaped(name)}" result="${skipped ? "skipped" : "completed"}">${inside}</testcase>`;
  };
  fs.writeFileSync(file, `<testsuites><testsuite>\n${cases.map(line).join("\n")}\n</testsuite></testsuites>\n`);
}

function checkTypes() {
  const package_ = path.join(here, "..");
  const done = spawnSync(path.join(package_, "node_modules/.bin/tsc"), { cwd: package_, encoding: "utf8" });
  if (done.status === 0) return { name: "tsc finds nothing wrong" };
  console.log(done.stdout, done.error ?? "");
  process.exitCode = 1;
  return { name: "tsc finds nothing wrong", failure: "" };
}

let esbuild;
try {
  esbuild = await import("esbuild");
} catch {
  const skipped = "the page's npm packages are not installed: bringup/install_packages";
  writeResult([{ name: "operator_page", skipped }]);
  console.log(`skipped: ${skipped}`);
  process.exit(0);
}

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
const cases = [checkTypes()];
const tests = run({ files, concurrency: 2 });
tests.on("test:pass", ({ name, details }) => {
  if (details.type !== "suite") cases.push({ name });
});
tests.on("test:fail", ({ name, details }) => {
  process.exitCode = 1;
  if (details.type !== "suite") cases.push({ name, failure: "" });
});
tests.compose(new spec()).pipe(process.stdout);
tests.on("end", () => {
  if (cases.length < 2) process.exitCode = 1;
  writeResult(cases);
  fs.rmSync(folder, { recursive: true });
});
