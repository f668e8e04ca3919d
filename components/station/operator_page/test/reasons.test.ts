// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { describe, it } from "node:test";

import { reasonText } from "../src/model/reasons.ts";

const header = path.join(import.meta.dirname, "../../../libraries/decision/include/decision/policy.hpp");

describe("Reasons of a decision", () => {
  it("has words for each that closes or opens the gate of a running vehicle", () => {
    const [, list] = /enum class Reason \{(.*?)\}/s.exec(fs.readFileSync(header, "utf8")) ?? [];
    const reasons = [...(list ?? "").matchAll(/^ {2}(\w+),/gm)].map(([, word]) => word ?? "");
    assert.ok(reasons.length > 15);
    const unsaid = reasons.filter((reason) => reasonText(reason) === reason);
    assert.deepEqual(unsaid, [
      ...["start", "steady", "no_measurement", "stale_sample"], // change nothing
      ...["legacy_drop", "legacy_count", "foreseen"], // of the thesis's source and of the clairvoyant
    ]);
  });
  it("leaves a word that it does not know", () => assert.equal(reasonText("new_rule"), "new_rule"));
});
