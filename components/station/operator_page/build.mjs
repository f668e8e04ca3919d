// SPDX-License-Identifier: Apache-2.0
// Bundles the pages: `node build.mjs FOLDER [TYPES...]` writes index.html, page.js and page.css there, fleet.html and
// fleet.js, and each of them compressed. TYPES are the folders that idl/ was printed to. Without npm's packages the folder stays
// empty, and a line says so. Fails when the page is larger than a phone should wait for.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

import { takeIdlTypes } from "./idl_types.mjs";

const mostCompressedBytes = 150_000;
const here = path.dirname(fileURLToPath(import.meta.url));
const target = path.resolve(process.argv[2] ?? "dist");

fs.rmSync(target, { recursive: true, force: true });
fs.mkdirSync(target, { recursive: true });
let esbuild;
try {
  esbuild = await import("esbuild");
} catch {
  console.log("operator_page: not built, its npm packages are not installed (bringup/install_packages)");
  process.exit(0);
}

const types = process.argv.slice(3);
takeIdlTypes(types.length > 0 ? types : undefined);
const common = { outdir: target, bundle: true, minify: true, logLevel: "warning" };
await esbuild.build({
  ...common,
  entryPoints: { page: path.join(here, "src/main.tsx"), fleet: path.join(here, "src/fleet_main.tsx") },
  format: "esm",
  target: ["es2022", "chrome111", "firefox113", "safari16.4"],
  jsx: "automatic",
  jsxImportSource: "preact",
  define: { "process.env.NODE_ENV": '"production"' },
  legalComments: "eof",
});
await esbuild.build({ ...common, entryPoints: { page: path.join(here, "src/style.css") } });
for (const name of ["index.html", "fleet.html"]) fs.copyFileSync(path.join(here, "src", name), path.join(target, name));

const compressedSize = (name) => {
  const compressed = gzipSync(fs.readFileSync(path.join(target, name)), { level: 9 });
  fs.writeFileSync(path.join(target, `${name}.gz`), compressed);
  return compressed.length;
};
const style = compressedSize("page.css");
for (const page of ["page", "fleet"]) {
  const total = style + compressedSize(page === "page" ? "index.html" : "fleet.html") + compressedSize(`${page}.js`);
  console.log(`operator_page: ${page}: ${total} bytes compressed`);
  if (total > mostCompressedBytes) {
    console.error(`operator_page: more than ${mostCompressedBytes} bytes`);
    process.exit(1);
  }
}
