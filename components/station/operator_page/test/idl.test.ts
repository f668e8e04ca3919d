// SPDX-License-Identifier: Apache-2.0
// What the page states of messages is what idl/ states.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { describe, it } from "node:test";

import { allPublished } from "../src/protocol/published.ts";
import { structs } from "./idl_structs.ts";

const here = import.meta.dirname;

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
