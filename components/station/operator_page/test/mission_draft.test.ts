// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { type MissionDraft, add, draftOf, emptyDraft, moveBy, moveTo, placeAt, remove, reorder, select, turnBy, turnTo } from "../src/model/mission_draft.ts";

const at = (x: number, y = 0) => ({ x, y, yaw: 0 });
const three = draftOf([at(1), at(2), at(3)]);
const xs = (draft: MissionDraft): number[] => draft.places.map(({ x }) => x);

describe("MissionDraft", () => {
  it("adds places one after the other, each heading away from the one before", () => {
    const one = add(emptyDraft, { x: 0, y: 1 }, { x: 0, y: 0 });
    const two = add(one, { x: -1, y: 1 });
    assert.deepEqual(two.places, [{ x: 0, y: 1, yaw: Math.PI / 2 }, { x: -1, y: 1, yaw: Math.PI }]);
    assert.equal(two.selected, 1);
    assert.equal(add(emptyDraft, at(1)).places[0]?.yaw, 0);
  });
  it("adds behind the selected place", () => {
    const sut = add(select(three, 0), at(1.5));
    assert.deepEqual([xs(sut), sut.selected], [[1, 1.5, 2, 3], 1]);
  });
  it("moves and turns the selected place only", () => {
    const sut = turnTo(moveTo(select(three, 1), { x: 7, y: 8 }), 1);
    assert.deepEqual(sut.places, [at(1), { x: 7, y: 8, yaw: 1 }, at(3)]);
    assert.deepEqual(moveBy(sut, 0.5, -1).places[1], { x: 7.5, y: 7, yaw: 1 });
    assert.ok(Math.abs((turnBy(sut, 3).places[1]?.yaw ?? 0) - (4 - 2 * Math.PI)) < 1e-9);
  });
  it("removes the selected place and selects the next one, or the last", () => {
    const first = remove(select(three, 0));
    assert.deepEqual([xs(first), first.selected], [[2, 3], 0]);
    const last = remove(three);
    assert.deepEqual([xs(last), last.selected], [[1, 2], 1]);
    assert.deepEqual(remove(remove(last)), emptyDraft);
    assert.equal(remove(emptyDraft), emptyDraft);
  });
  it("reorders within the mission", () => {
    const earlier = reorder(three, -1);
    assert.deepEqual([xs(earlier), earlier.selected], [[1, 3, 2], 1]);
    assert.deepEqual(xs(reorder(three, -9)), [3, 1, 2]);
    assert.deepEqual(reorder(three, 1), three);
    assert.equal(reorder(emptyDraft, 1), emptyDraft);
  });
  it("finds the place under a finger, the upper one of two", () => {
    assert.equal(placeAt(three, { x: 2.2, y: 0 }, 0.3), 1);
    assert.equal(placeAt(three, { x: 2.5, y: 1 }, 0.3), undefined);
    assert.equal(placeAt(draftOf([at(1), at(1)]), at(1), 0.3), 1);
  });
  it("selects no place that there is not", () => {
    assert.equal(select(three, 3), three);
    assert.equal(select(three, -1), three);
    assert.equal(draftOf([]).selected, undefined);
  });
  it("leaves the draft before as it was", () => {
    add(three, at(9));
    remove(three);
    assert.deepEqual(xs(three), [1, 2, 3]);
  });
});
