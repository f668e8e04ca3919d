// SPDX-License-Identifier: Apache-2.0
// Brings recordings of simulated missions into a real PostgreSQL and an S3 server, with outages of both.
// usage: node run.mjs --install=PREFIX [--gtest_output=xml:FILE]
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { run } from "node:test";
import { spec } from "node:test/reporters";
import { fileURLToPath } from "node:url";

import { collectCases, skip } from "../../components/station/operator_page/test/result_file.mjs";
import { postgresqlPrograms } from "./engines.mjs";

const here = path.dirname(fileURLToPath(import.meta.url));
const prefix = process.argv.find((word) => word.startsWith("--install=")).slice("--install=".length);

/** The install folder is one for all packages, or has a folder for each, or is one of these. */
const places = ["bin/tocsin", "tocsin_cli/bin/tocsin", "../tocsin_cli/bin/tocsin"];
const tocsin = places.map((place) => path.join(prefix, place)).find(fs.existsSync);

if (!fs.existsSync(path.join(here, "node_modules/s3rver"))) skip("archive_engines_test", "npm packages are not installed: bringup/install_packages --tests");
if (!postgresqlPrograms()) skip("archive_engines_test", "postgresql is not installed: bringup/install_packages --tests");

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "archive_test_"));
fs.chmodSync(folder, 0o755); // another user's PostgreSQL looks for its data below it
process.env.ARCHIVE_TEST = JSON.stringify({ tocsin, folder });
const tests = run({ files: [path.join(here, "archive_test.mjs")] });
collectCases(tests);
tests.compose(new spec()).pipe(process.stdout);
tests.on("end", () => fs.rmSync(folder, { recursive: true, force: true }));
