// SPDX-License-Identifier: Apache-2.0
// What the page states of messages is what idl/ states.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { describe, it } from "node:test";

import { allPublished } from "../src/protocol/published.ts";

const here = import.meta.dirname;
const idl = path.join(here, "../../../../idl");
const basic: Record<string, string> = {
  "unsigned long long": "uint64", "long long": "int64", "unsigned long": "uint32", long: "int32",
  double: "float64", float: "float32", boolean: "bool", octet: "byte", uint8: "uint8",
};

const rosType = (text: string): string => {
  const list = /^sequence<(.*)>$/.exec(text);
  if (list?.[1]) return `${rosType(list[1])}[]`;
  return basic[text] ?? text.replace("::msg::", "/");
};

/** Fields of all structs, by "package/Type": "type name". */
function structs(): Map<string, string[]> {
  const found = new Map<string, string[]>();
  for (const folder of ["ros_idl", "tocsin_idl"]) {
    for (const file of fs.readdirSync(path.join(idl, folder, "idl"))) {
      const text = fs.readFileSync(path.join(idl, folder, "idl", file), "utf8").replace(/\/\/.*/g, "");
      const module = /module (\w+) \{ module msg/.exec(text)?.[1] ?? "";
      for (const [, name, body] of text.matchAll(/struct (\w+) \{([^}]*)\}/g)) {
        const fields = [...(body ?? "").matchAll(/^\s*(?:@default\([^)]*\)\s*)?([\w:<> ]+?)\s+(\w+)(\[\d+\])?;/gm)];
        found.set(`${module}/${name}`, fields.map(([, type, field]) => `${rosType(type ?? "")} ${field}`));
      }
    }
  }
  return found;
}

describe("What the page writes", () => {
  const known = structs();
  for (const { schemaName, text } of allPublished) {
    it(`${schemaName} has the fields of the IDL`, () => {
      const parts = text.split(`\n${"=".repeat(80)}\n`);
      parts.forEach((part, index) => {
        const lines = part.split("\n");
        const name = index === 0 ? schemaName.replace("/msg/", "/") : (lines.shift() ?? "").replace("MSG: ", "");
        assert.deepEqual(lines, known.get(name), name);
      });
    });
  }
});

describe("What the page reads", () => {
  it("names only fields that the IDL has", () => {
    const text = fs.readFileSync(path.join(here, "../src/model/messages.ts"), "utf8");
    const byType = new Map([...structs()].map(([name, fields]) => [name.split("/")[1], fields]));
    let compared = 0;
    for (const [, name, body] of text.matchAll(/export interface (\w+)[^{]*\{\n(.*?)^\}/gms)) {
      const fields = byType.get(name ?? "")?.map((field) => field.split(" ")[1]);
      if (!fields) continue; // of a package that this repository does not restate
      for (const [, field] of (body ?? "").matchAll(/^ {2}readonly (\w+):/gm)) {
        assert.ok(fields.includes(field), `${name}.${field} is not in the IDL`);
        ++compared;
      }
    }
    assert.ok(compared > 100, `${compared} fields were compared`);
  });
});
