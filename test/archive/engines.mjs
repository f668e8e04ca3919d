// SPDX-License-Identifier: Apache-2.0
// PostgreSQL and an S3 server, each started, stopped and started again with what it has, on ports of 127.0.0.1.
import { spawn, spawnSync } from "node:child_process";
import fs from "node:fs";
import net from "node:net";
import path from "node:path";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));

/** Folder of initdb and pg_ctl; Debian keeps them out of $PATH. */
export function postgresqlPrograms() {
  const root = "/usr/lib/postgresql";
  if (!fs.existsSync(root)) return undefined;
  const versions = fs.readdirSync(root).sort((one, other) => Number(other) - Number(one));
  return versions.map((version) => path.join(root, version, "bin")).find((bin) => fs.existsSync(path.join(bin, "initdb")));
}

export function freePort() {
  return new Promise((resolve) => {
    const server = net.createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

/** Runs it to its end. Throws what it said when that was bad. */
export function execute(command, words, options = {}) {
  const ended = spawnSync(command, words, { encoding: "utf8", ...options });
  if (ended.status !== 0) throw new Error(`${command} ${words.join(" ")}: ${ended.stdout}${ended.stderr}${ended.error ?? ""}`);
  return ended.stdout;
}

export class Postgresql {
  /** In a folder of its own. It refuses to run as root, so then it runs as the user of Debian's package. */
  constructor(folder, port) {
    this.bin = postgresqlPrograms();
    this.data = path.join(folder, "data");
    this.port = port;
    this.folder = folder;
    this.as = process.getuid() === 0 ? ["setpriv", "--reuid=postgres", "--regid=postgres", "--clear-groups"] : ["env"];
    this.url = `postgresql://postgres@127.0.0.1:${port}/postgres?connect_timeout=5`;
    fs.mkdirSync(folder);
    if (process.getuid() === 0) execute("chown", ["postgres", folder]);
    this.#run("initdb", ["-D", this.data, "-U", "postgres", "--auth=trust", "--no-sync"]);
  }

  start() {
    const settings = `-p ${this.port} -c listen_addresses=127.0.0.1 -k ${this.folder}`;
    this.#run("pg_ctl", ["-D", this.data, "-w", "-l", path.join(this.folder, "log"), "-o", settings, "start"]);
  }

  stop() {
    this.#run("pg_ctl", ["-D", this.data, "-w", "-m", "immediate", "stop"]);
  }

  /** Rows of columns. */
  ask(statement) {
    const text = execute(path.join(this.bin, "psql"), [this.url, "-At", "-F", "\t", "-c", statement]);
    return text.split("\n").filter(Boolean).map((row) => row.split("\t"));
  }

  #run(program, words) {
    const [command, ...before] = this.as;
    // Its server inherits no pipe of ours, which would hold up whoever reads that.
    execute(command, [...before, path.join(this.bin, program), ...words], { stdio: ["ignore", "ignore", "inherit"], cwd: "/" });
  }
}

export class Bucket {
  constructor(folder, port, name) {
    this.folder = folder;
    this.port = port;
    this.name = name;
    this.environment = {
      ...{ AWS_ENDPOINT_URL: `http://127.0.0.1:${port}`, AWS_REGION: "eu-central-1" },
      ...{ AWS_ACCESS_KEY_ID: "S3RVER", AWS_SECRET_ACCESS_KEY: "S3RVER" },
    };
  }

  async start() {
    const program = path.join(here, "node_modules/s3rver/bin/s3rver.js");
    const where = ["--directory", this.folder, "--address", "127.0.0.1", "--port", String(this.port)];
    this.server = spawn(process.execPath, [program, ...where, "--configure-bucket", this.name, "--silent"], { stdio: "ignore" });
    const end = Date.now() + 20000;
    for (;;) {
      const good = await fetch(`http://127.0.0.1:${this.port}/${this.name}`).then(({ ok }) => ok, () => false);
      if (good) return;
      if (Date.now() > end) throw new Error("the S3 server does not answer");
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }

  stop() {
    return new Promise((resolve) => {
      this.server.on("exit", resolve);
      this.server.kill("SIGKILL");
    });
  }

  /** Names of all objects. */
  async objects() {
    const text = await fetch(`http://127.0.0.1:${this.port}/${this.name}?list-type=2`).then((answer) => answer.text());
    return [...text.matchAll(/<Key>([^<]*)<\/Key>/g)].map(([, key]) => key);
  }
}
