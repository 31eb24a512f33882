// SPDX-License-Identifier: GPL-3.0-or-later
// Old schema versions read as the newest: the cases of reports/record/old_record_test.cpp.
import assert from "node:assert/strict";
import { test } from "node:test";
import { upgraded } from "../make/old_record.mjs";
import { old_check, old_record, record } from "./records.mjs";

const zero = (change) => old_check({ expected: 0, scale: 1, digits: 5.7, ...change });
const only = (check, change = {}) => upgraded(old_record({ checks: [check], ...change })).checks[0];

test("digits of no scale are left out", () => {
  const check = only(zero({ error: 2e-6, tolerance: 1e-6 }));
  assert.ok(!("digits" in check) && !("scale" in check));
  assert.ok(Math.abs(check.of_tolerance - 2) < 1e-12);
  assert.equal(only(zero({ error: "nan" })).of_tolerance, "inf");
  assert.equal(only(zero({ error: 0, tolerance: 0 })).of_tolerance, 0);
});

test("digits of a scale stay", () => {
  assert.equal(only(zero({ scale: 0.2 })).scale, 0.2);
  assert.equal(only(zero({ scale: 0.2 })).digits, 5.7);
  const one = only(zero({ expected: 1 }));
  assert.equal(one.digits, 5.7);
  assert.ok(!("scale" in one), "the expected value is it");
});

test("a limit is a shortfall with its band; in version 2 a cause without one", () => {
  const check = only(zero({ verdict: "limit", expected_low: 1e-6, expected_high: "inf" }));
  assert.equal(check.verdict, "expected-shortfall");
  assert.deepEqual(check.band, [1e-6, "inf"]);
  assert.equal(only(zero({ verdict: "limit", limit: "never settles" })).cause, "never settles");
});

test("figures and failures were checks and notes", () => {
  const one = upgraded(
    old_record({
      verdict: "shown",
      checks: [
        zero({ verdict: "shown", tolerance: 0, reason: "none: side by side", value: "inf" }),
      ],
      notes: ["a note", "failed: a body moved", "failed: gain = -0.5, 2.3", "it failed: no"],
    }),
  );
  assert.equal(one.verdict, "for-information");
  assert.deepEqual(one.checks, []);
  assert.equal(one.figures[0].value, "inf");
  assert.deepEqual(one.failures, [
    { reason: "a body moved", parameter: "", values: [] },
    { reason: "it broke", parameter: "gain", values: [-0.5, 2.3] },
  ]);
  assert.deepEqual(one.notes, ["a note", "it failed: no"]);
});

const only_failure = (text) => upgraded(old_record({ notes: [`failed: ${text}`] })).failures[0];

test("values of a failure are decimal numbers", () => {
  const { parameter, values } = only_failure("gain = 1e+20, 1e-05, -0.5, 5e-324, 1E3, .5");
  assert.equal(parameter, "gain");
  assert.deepEqual(values, [1e20, 1e-5, -0.5, 5e-324, 1e3, 0.5]);
});

test("a failure without such values is a text as it stands", () => {
  const numbers = ["...", ".", "-", "e", "1e", "+1", "--1", "1.2.3", "0x10", "nan", "-inf"];
  const lists = ["1e999", "1e-999", "1, 1e999", "1,2", "1 ", "1, ", ""];
  const texts = [...numbers, ...lists].map((values) => `gain = ${values}`);
  for (const text of [...texts, "gain  = 1", "gain\t= 1", "the gain = 1", " = 1", "gain", ""]) {
    assert.deepEqual(only_failure(text), { reason: text, parameter: "", values: [] });
  }
});

test("a shown check with a tolerance stays a check, and the newest version as it is", () => {
  assert.equal(only(zero({ verdict: "shown" })).verdict, "for-information");
  const newest = record();
  assert.equal(upgraded(newest), newest);
});

test("what is no record is left for the schema to refuse", () => {
  for (const checks of [undefined, 7, [null], ["x"]]) {
    assert.equal(upgraded({ ...old_record(), checks }).schema_version, 4);
  }
});
