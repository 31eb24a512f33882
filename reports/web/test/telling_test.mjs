// SPDX-License-Identifier: GPL-3.0-or-later
// What a player shows first, and how large.
import assert from "node:assert/strict";
import { test } from "node:test";
import { exaggerated, settled_frame, view_of } from "../page/player/playback.js";
import { telling_moment, telling_pair } from "../page/player/telling.js";
import { check, record } from "./records.mjs";

const UP = [0, 0, 1];

// A recording of boxes (cubes of edge `size`) whose middles are where(time).
function recording(boxes, times = [0, 1, 2, 3, 4]) {
  const vertices = boxes.length * 8;
  return {
    bodies: boxes.map(({ name }) => ({ name, vertices: 8, triangles: [] })),
    planes: [],
    times,
    ups: times.map(() => UP),
    frame(i) {
      const positions = new Float32Array(3 * vertices);
      boxes.forEach(({ size, where }, place) => {
        const middle = where(times[i]);
        for (let corner = 0; corner < 8; ++corner)
          for (let axis = 0; axis < 3; ++axis)
            positions[3 * (8 * place + corner) + axis] =
              middle[axis] + ((corner >> axis) & 1 ? 0.5 : -0.5) * size;
      });
      return { positions, contacts: [] };
    },
  };
}
const box = (where, size = 1, name = "box") => ({ name, size, where });
const still = box(() => [0, 0, 0]);

test("the moment: where two differ most, where one is fastest, else the end", () => {
  const out_and_back = box((t) => [t <= 2 ? t : 4 - t, 0, 0]);
  assert.equal(telling_moment([recording([still]), recording([out_and_back])]), 2);
  assert.equal(telling_moment([recording([box((t) => [t ** 3, 0, 0])])]), 4);
  assert.equal(telling_moment([recording([box((t) => [t < 1 ? 0 : 5, 0, 0])])]), 1);
  assert.equal(telling_moment([recording([still])]), 4);
  assert.equal(telling_moment([recording([still]), recording([still])]), 4);
  const hardly = box((t) => [1e-6 * t, 0, 0]);
  assert.equal(telling_moment([recording([hardly])]), 4);
  assert.equal(telling_moment([recording([still]), recording([still, still])]), 4, "other bodies");
});

test("the pair: worst against best, of the runs shown", () => {
  const runs = [{ role: "shown" }, { role: "against" }];
  const entry = (verdict, of_tolerance, run = 0) => ({
    record: { ...record({ verdict, checks: [check({ verdict, of_tolerance })] }), run },
  });
  const pair = (...entries) => telling_pair(entries, runs);
  assert.deepEqual(pair(entry("pass", 0.5), entry("fail", 2), entry("pass", 0.1)), [1, 2]);
  assert.deepEqual(
    pair(entry("refuted", 9), entry("for-information", 1e9), entry("pass", 0.1)),
    [0, 2],
  );
  assert.deepEqual(
    pair(entry("for-information", 1e9), entry("pass", 0.9), entry("pass", 0.1)),
    [0, 2],
  );
  assert.deepEqual(pair(entry("pass", 0.2), entry("fail", 2, 1), entry("pass", 0.1)), [0, 2]);
  assert.deepEqual(pair(entry("pass", 0.2), entry("pass", 0.2)), [0, 1]);
  assert.deepEqual(pair(entry("pass", "nan"), entry("pass", 0.2)), [0, 1]);
  assert.deepEqual(pair(entry("pass", 0.2)), [0, 0]);
});

test("displacements grow from the reference; what the recording cannot resolve stays", () => {
  const step = [0.001, 0.001, 0.001];
  const drawn = exaggerated(
    Float32Array.from([1, 0.0005, 0.01]),
    Float32Array.from([1, 0, 0]),
    100,
    step,
  );
  assert.deepEqual(
    [...drawn].map((x) => Number(x.toFixed(4))),
    [1, 0, 1],
  );
});

test("the reference is the frame from which gravity stays", () => {
  const tilted = [0.6, 0, 0.8];
  assert.equal(settled_frame({ ups: [UP, UP, tilted, tilted, tilted] }), 2);
  assert.equal(settled_frame({ ups: [UP, UP, UP] }), 0);
  assert.equal(settled_frame({ ups: [UP, UP, tilted] }), 0, "it never stays");
});

test("the camera frames the objects: neither their ground nor what flies off", () => {
  const ground = box(() => [0, 0, -3], 6, "slab");
  const { radius, centre } = view_of([recording([still, ground])], 4);
  assert.ok(radius < 1.5, `${radius}`);
  assert.ok(Math.abs(centre[2]) < 0.1);
  const flying = box((t) => [100 * t, 0, 0]);
  assert.ok(view_of([recording([still]), recording([flying])], 4).radius < 2);
  const walking = box((t) => [0.5 * t, 0, 0]);
  const way = view_of([recording([walking])], 4);
  assert.ok(way.radius > 1.3, "the way is seen");
});
