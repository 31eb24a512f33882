// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a run are shown as the run in one piece.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, symlinkSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { lines_of, record } from "./records.mjs";
import { make_page, report } from "./report.mjs";
import { temporary_folder } from "./temporary.mjs";

const RECORDS = ["a/x", "b/y", "c/z", "d/w"].map((name, job) => record({ case: name, job }));

// An out-dir with runs: [name, number of the part, how many parts, its records].
function out_dir(runs, plan = "0123456789abcdef") {
  const folder = temporary_folder();
  for (const [name, number, count, records] of runs) {
    mkdirSync(join(folder, name));
    writeFileSync(join(folder, name, "records.jsonl"), records.length > 0 ? lines_of(records) : "");
    const told = { plan, jobs: RECORDS.length, shard: { number, count } };
    writeFileSync(join(folder, name, "run.json"), JSON.stringify(told));
  }
  symlinkSync(runs.at(-1)[0], join(folder, "latest"));
  return folder;
}

const OLD = "2026-01-01T00-00-01Z";
const NEW = "2026-01-01T00-00-02Z";
const [a, b, c, d] = RECORDS;
const whole = () => out_dir([[NEW, 1, 1, RECORDS]]);
const bytes_of = (...folders) => readFileSync(make_page(...folders), "latin1");

test("an out-dir of parts, and the parts one by one, are the page of one piece", () => {
  const wanted = bytes_of(whole());
  const parts = out_dir([
    [OLD, 1, 2, [a, d]],
    [NEW, 2, 2, [b, c]],
  ]);
  assert.ok(bytes_of(parts) === wanted);
  assert.ok(bytes_of(join(parts, OLD), join(parts, NEW)) === wanted);
  assert.ok(bytes_of(join(parts, NEW), join(parts, OLD)) === wanted);
});

test("a part that ran twice counts once, by its newest record; an empty one is no fault", () => {
  const slow = { ...a, cost: { ...a.cost, cpu_seconds: 77 } };
  const parts = out_dir([
    ["2026-01-01T00-00-00Z", 1, 3, [slow, d]],
    ["2026-01-01T00-00-01Z", 1, 3, [a, d]],
    ["2026-01-01T00-00-01Z-2", 3, 3, []],
    [NEW, 2, 3, [b, c]],
  ]);
  assert.ok(bytes_of(parts) === bytes_of(whole()));
});

test("of the runs of one second the last counts, and a result before what broke off", () => {
  const slow = { ...a, cost: { ...a.cost, cpu_seconds: 77 } };
  const broke = { ...d, verdict: "error", error: "too slow" };
  const parts = out_dir([
    [OLD, 1, 2, [slow, d]],
    [`${OLD}-9`, 1, 2, [slow, d]],
    [`${OLD}-11`, 1, 2, [a, broke]],
    [NEW, 2, 2, [b, c]],
  ]);
  assert.ok(bytes_of(parts) === bytes_of(whole()));
});

test("what is missing is told", () => {
  const parts = out_dir([[NEW, 2, 2, [b, c]]]);
  const { status, err } = report(parts, "--out", join(parts, "page.html"));
  assert.equal(status, 0);
  assert.match(err, /2 of 4 jobs have no record: some part is missing, or was interrupted/);
});

test("parts of different runs are not mixed", () => {
  const one = out_dir([[OLD, 1, 2, [a, d]]]);
  const other = out_dir([[NEW, 2, 2, [b, c]]], "fedcba9876543210");
  const { err } = report(one, other, "--out", join(one, "page.html"));
  assert.equal(err.match(/jobs have no record/g).length, 1, "the same sentence of both, once");
  assert.match(
    readFileSync(join(one, "page.html"), "latin1"),
    /2026-01-01T00-00-01Z, 2026-01-01T00-00-02Z/,
  );
});

test("a run.json that is none is no part", () => {
  const folder = whole();
  const wanted = bytes_of(folder);
  for (const text of ["", "{}", '{"plan":"x","jobs":4,"shard":{"number":1,"count":"2"}}']) {
    writeFileSync(join(folder, NEW, "run.json"), text);
    assert.ok(bytes_of(folder) === wanted);
  }
});
