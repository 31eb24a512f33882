// SPDX-License-Identifier: GPL-3.0-or-later
// data/sliding-box.bin is written by reports/recording/frames.cpp; frames_test.cpp holds it to the byte.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { decode_frames } from "../model/frames.js";

const file = readFileSync(new URL("data/sliding-box.bin", import.meta.url));
const bytes = file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength);
const near = (a, b, by) => assert.ok(Math.abs(a - b) <= by, `${a} is not near ${b}`);

test("what C++ wrote is read", () => {
  const recording = decode_frames(bytes);
  assert.equal(recording.title, "a box slides and stops");
  assert.equal(recording.times.length, 41);
  assert.equal(recording.bodies[0].triangles.length, 36);
  assert.deepEqual(recording.planes[0].normal, [0, 0, 1]);
  const quantum = 1.2 / 65535;
  const first = recording.frame(0);
  near(first.positions[0], -0.1, quantum);
  near(first.contacts[0].normal_force[2], 9.81 / 4, 1e-3);
  near(first.contacts[0].friction_force[0], -9.81 / 8, 1e-3);
  assert.equal(first.contacts[0].sticks, false);
  const last = recording.frame(40);
  near(last.positions[0], 0.9, quantum);
  assert.equal(last.contacts[3].sticks, true);
  assert.deepEqual(recording.ups[40], [0, 0, 1]);
});

test("gravity tells the way up, also while nothing weighs yet", () => {
  const header = {
    title: "",
    bodies: [],
    planes: [],
    low: [0, 0, 0],
    high: [1, 1, 1],
    force: 0,
    times: [0, 1, 2, 3],
    gravity: [
      [0, 0, 0],
      [0, -3, -4],
      [0, 0, -2],
      [0, 0, 0],
    ],
    contacts: [0, 0, 0, 0],
  };
  const text = JSON.stringify(header);
  const all = new Uint8Array(12 + Math.ceil(text.length / 4) * 4).fill(32);
  all.set(new TextEncoder().encode("STFR"));
  new DataView(all.buffer).setUint32(4, 1, true);
  new DataView(all.buffer).setUint32(8, all.length - 12, true);
  all.set(new TextEncoder().encode(text), 12);
  assert.deepEqual(decode_frames(all.buffer).ups, [
    [0, 0.6, 0.8],
    [0, 0.6, 0.8],
    [0, 0, 1],
    [0, 0, 1],
  ]);
});

test("cut off, lengthened or foreign bytes are refused", () => {
  for (let length = 0; length < bytes.byteLength; length += 11)
    assert.throws(() => decode_frames(bytes.slice(0, length)), /cannot be read/);
  assert.throws(() => decode_frames(new Uint8Array([...file, 0]).buffer), /bytes instead of/);
  assert.throws(
    () => decode_frames(new TextEncoder().encode("{}".padEnd(64)).buffer),
    /no frames file/,
  );
  const newer = bytes.slice(0);
  new DataView(newer).setUint32(4, 2, true);
  assert.throws(() => decode_frames(newer), /version, 2, is newer/);
});

test("a header cannot ask for more than the file holds", () => {
  const header = JSON.stringify({
    title: "",
    bodies: [{ name: "x", vertices: 4294967295, triangles: 4294967295 }],
    planes: [],
    low: [0, 0, 0],
    high: [1, 1, 1],
    force: 0,
    times: [0],
    gravity: [[0, 0, -9.81]],
    contacts: [4294967295],
  });
  const padded = header.padEnd(Math.ceil(header.length / 4) * 4);
  const all = new Uint8Array(12 + padded.length);
  all.set(new TextEncoder().encode("STFR"));
  new DataView(all.buffer).setUint32(4, 1, true);
  new DataView(all.buffer).setUint32(8, padded.length, true);
  all.set(new TextEncoder().encode(padded), 12);
  assert.throws(() => decode_frames(all.buffer), /bytes instead of/);
});
