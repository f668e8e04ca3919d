// SPDX-License-Identifier: Apache-2.0
// Puts the TypeScript that idl/ was printed to at build time where the page's sources find it: generated/.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const packages = ["ros_idl", "tocsin_idl"];

/** Where a build of this repository has put it: an install folder is one for all packages, or has one for each. */
function installed(name) {
  const install = path.join(here, "../../../install");
  const places = [path.join(install, name), install].map((prefix) => path.join(prefix, "share", name, "ts"));
  return places.find((place) => fs.existsSync(place));
}

/** `folders`: of each package; without any, those of this repository's build. Writes only what differs. */
export function takeIdlTypes(folders = packages.map(installed)) {
  const target = path.join(here, "generated");
  const missing = folders.some((folder) => folder === undefined);
  if (missing && !fs.existsSync(target)) throw new Error("operator_page: idl/ is not built: bringup/build system --packages-up-to tocsin_idl");
  if (missing) return;
  fs.mkdirSync(target, { recursive: true });
  const wanted = new Map(folders.flatMap((folder) => fs.readdirSync(folder).map((name) => [name, path.join(folder, name)])));
  for (const name of fs.readdirSync(target)) if (!wanted.has(name)) fs.rmSync(path.join(target, name));
  for (const [name, source] of wanted) put(path.join(target, name), fs.readFileSync(source, "utf8"));
}

/** A build and a test may do so at the same time. */
function put(file, text) {
  if (fs.existsSync(file) && fs.readFileSync(file, "utf8") === text) return;
  const scratch = `${file}.${process.pid}`;
  fs.writeFileSync(scratch, text);
  fs.renameSync(scratch, file);
}
