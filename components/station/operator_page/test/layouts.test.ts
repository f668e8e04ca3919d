// SPDX-License-Identifier: Apache-2.0
// The layouts for Foxglove and Lichtblick name topics and fields that there are.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { describe, it } from "node:test";

const repository = path.join(import.meta.dirname, "../../../..");
const folder = path.join(repository, "config/layouts");

/** The type of each topic of the lists, "package/Type" by name. */
function topics(): Map<string, string> {
  const text = fs.readFileSync(path.join(repository, "idl/tocsin_idl/include/tocsin_idl/topics.hpp"), "utf8");
  const found = text.matchAll(/using Message = (\w+)::msg::(\w+);\s*static constexpr TopicInfo info\{"([^"]+)"/g);
  return new Map([...found].map(([, pack, type, name]) => [`/${name}`, `${pack}/${type}`]));
}

/** The names of the fields of each message, by "package/Type". */
function fieldsOfTypes(): Map<string, string[]> {
  const printed = path.join(import.meta.dirname, "../generated");
  const texts = fs.readdirSync(printed).map((name) => fs.readFileSync(path.join(printed, name), "utf8"));
  return new Map(texts.flatMap((text) => [...text.matchAll(/^export const \w+ = (\{.*\});$/gm)].map(([, json]) => {
    const { schemaName, text: definition } = JSON.parse(json ?? "") as { schemaName: string; text: string };
    const own = (definition.split("\n===")[0] ?? "").split("\n");
    return [schemaName.replace("/msg/", "/"), own.map((line) => line.split(" ")[1] ?? "")];
  })));
}

/** All texts of a layout that are message paths: "/topic{filter}.field". */
function messagePaths(value: unknown): string[] {
  if (typeof value === "string") return /^\/[\w/]+(\{|\.|$)/.test(value) ? [value] : [];
  if (typeof value !== "object" || value === null) return [];
  const inside = Object.entries(value).filter(([key]) => key !== "publish");
  return inside.flatMap(([key, one]) => [...messagePaths(key), ...messagePaths(one)]);
}

/** Known to Studio 1.48 as well as to Lichtblick, which makes its newer image panel of the older one. */
const panelTypes = ["3D", "DiagnosticSummary", "ImageViewPanel", "Plot", "RawMessages", "StateTransitions"];

describe("Layouts", () => {
  const known = topics();
  const fields = fieldsOfTypes();
  for (const file of fs.readdirSync(folder)) {
    const layout = JSON.parse(fs.readFileSync(path.join(folder, file), "utf8"));
    it(`${file} names topics and fields of the IDL`, () => {
      const paths = messagePaths(layout.configById);
      assert.ok(paths.length > 10, `${paths.length} paths`);
      for (const one of paths) {
        const [, topic, filter, field] = /^([^{.]+)(?:\{(\w+)==[^}]*\})?(?:\.(\w+))?$/.exec(one) ?? [];
        const type = known.get(topic ?? "");
        assert.ok(type, `${one}: there is no such topic`);
        const names = fields.get(type) ?? [];
        for (const name of [filter, field]) if (name) assert.ok(names.includes(name), `${one}: ${type} has no ${name}`);
      }
    });
    it(`${file} has panels that Studio and Lichtblick know`, () => {
      const types = Object.keys(layout.configById).map((id) => id.split("!")[0]);
      assert.deepEqual(types.filter((type) => !panelTypes.includes(type ?? "")), []);
    });
    it(`${file} shows each of its panels once`, () => {
      const shown = (node: unknown): string[] =>
        typeof node === "string" ? [node] : ["first", "second"].flatMap((end) => shown((node as Record<string, unknown>)[end]));
      assert.deepEqual(shown(layout.layout).sort(), Object.keys(layout.configById).sort());
    });
  }
});
