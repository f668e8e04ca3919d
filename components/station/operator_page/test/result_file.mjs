// SPDX-License-Identifier: Apache-2.0
// Results of node's test runner as GoogleTest writes them (`--gtest_output=xml:FILE`), so that
// test/run_tests.py counts the cases.
import fs from "node:fs";

const file = process.argv.find((word) => word.startsWith("--gtest_output=xml:"))?.split("xml:")[1];
const escaped = (text) => text.replace(/[^\w .,:;()/'-]/g, (one) => `&#${one.codePointAt(0)};`);

/** Cases are { name, failed, skipped }, the last two undefined, or true and the reason. */
function write(cases) {
  if (!file) return;
  const line = ({ name, failed, skipped }) => {
    const inside = failed ? "<failure/>" : skipped ? `<skipped message="${escaped(skipped)}"/>` : "";
    return `<testcase name="${escaped(name)}" result="${skipped ? "skipped" : "completed"}">${inside}</testcase>`;
  };
  fs.writeFileSync(file, `<testsuites><testsuite>\n${cases.map(line).join("\n")}\n</testsuite></testsuites>\n`);
}

/** Ends the process with one case that was skipped. */
export function skip(name, reason) {
  write([{ name, skipped: reason }]);
  console.log(`skipped: ${reason}`);
  process.exit(0);
}

/** Writes the cases of a run of node:test when it ends, behind those of `first`. */
export function collectCases(tests, first = []) {
  const cases = [...first];
  const take = (failed) => ({ name, details }) => {
    if (failed) process.exitCode = 1;
    if (details.type !== "suite") cases.push({ name, failed });
  };
  tests.on("test:pass", take(false));
  tests.on("test:fail", take(true));
  tests.on("end", () => {
    if (cases.length === first.length || cases.some(({ failed }) => failed)) process.exitCode = 1;
    write(cases);
  });
}
