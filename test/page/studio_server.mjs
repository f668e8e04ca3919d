// SPDX-License-Identifier: Apache-2.0
// Serves Foxglove Studio as a web page, the shipped layout, and a bag, as Studio reads them.
import fs from "node:fs";
import http from "node:http";
import path from "node:path";

const here = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);
/** The address of Lichtblick's container, which operator_server lets in. */
export const studioPort = 8080;
const types = { ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".json": "application/json",
  ".wasm": "application/wasm", ".svg": "image/svg+xml", ".png": "image/png", ".ttf": "font/ttf" };

/** `bag`: of /bag.mcap, asked for each time. */
export function serveStudio(layout, bag) {
  const server = http.createServer((request, response) => {
    const name = decodeURIComponent(new URL(request.url, "http://x").pathname);
    const special = { "/layout.json": layout, "/bag.mcap": bag() };
    const file = special[name] ?? path.join(here, "studio", name === "/" ? "index.html" : path.normalize(name));
    if (!fs.existsSync(file)) return response.writeHead(404).end();
    send(file, request, response);
  });
  return new Promise((resolve, reject) => server.on("error", reject).listen(studioPort, "127.0.0.1", () => resolve(server)));
}

function send(file, request, response) {
  const { size } = fs.statSync(file);
  const head = { "content-type": types[path.extname(file)] ?? "application/octet-stream", "accept-ranges": "bytes" };
  const [, begin, end] = /bytes=(\d+)-(\d*)/.exec(request.headers.range ?? "") ?? [];
  const [start, last] = [Number(begin ?? 0), end ? Math.min(Number(end), size - 1) : size - 1];
  const range = begin === undefined ? {} : { "content-range": `bytes ${start}-${last}/${size}` };
  response.writeHead(begin === undefined ? 200 : 206, { ...head, ...range, "content-length": last - start + 1 });
  if (request.method === "HEAD") return response.end();
  fs.createReadStream(file, { start, end: last }).pipe(response);
}
