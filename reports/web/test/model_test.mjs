// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { band_text, margin, margin_text, short_margin, value_text } from "../model/check_text.js";
import { compare, cost_noise, same_reason } from "../model/compare.js";
import { family_name, short_name } from "../model/family.js";
import { natural_sort } from "../model/natural.js";
import {
  format_count,
  format_digits,
  format_error,
  format_pair,
  format_seconds,
  format_value,
  to_number,
} from "../model/number.js";
import { variant_labels } from "../model/variant.js";
import { fewest_digits, worst_check } from "../model/verdict.js";
import { filtered, sorted } from "../page/widgets/filter.js";
import { instant, place_at, view_of } from "../page/player/playback.js";
import { hash_of, parse_hash } from "../page/route.js";
import { check, record } from "./records.mjs";

// The expected texts are those of reports/text/number_test.cpp and of printf("%.6g").
test("numbers are spelled as in the Markdown report", () => {
  const texts = [
    [0.1 + 0.2, "0.3"],
    [1234567, "1.23457e+06"],
    [123456, "123456"],
    [1e-4, "0.0001"],
    [1e-5, "1e-05"],
    [-0, "0"],
    [NaN, "nan"],
    [-Infinity, "-inf"],
    [1e100, "1e+100"],
    [999999.5, "1e+06"],
    [0.265962865780865, "0.265963"],
  ];
  for (const [value, text] of texts) assert.equal(format_value(value), text);
  assert.equal(format_error(0.00096234), "0.00096");
  assert.equal(format_error(100), "1e+02");
  assert.equal(format_digits(4.449), "4.4");
  assert.equal(format_seconds(1234.6), "1235");
  assert.equal(format_count(9685906), "9,685,906");
  assert.equal(format_count(12), "12");
});

test("numbers that JSON lacks are read", () => {
  assert.ok(Number.isNaN(to_number("nan")));
  assert.equal(to_number("-inf"), -Infinity);
  assert.ok(Number.isNaN(to_number("7")));
});

test("a measured value has the digits that tell it from the expected one", () => {
  assert.deepEqual(format_pair(0.139765, 0.138803), ["0.139765", "0.138803"]);
  assert.deepEqual(format_pair(1.00000013, 1), ["1.0000001", "1"]);
  assert.equal(value_text(check({ value: 2, expected: 2, unit: "1" })), "2");
});

test("margins", () => {
  assert.equal(margin(check({ of_tolerance: 0.5 })), 0.5);
  assert.equal(margin(check({ of_tolerance: "inf" })), Infinity);
  assert.equal(margin_text(0.5), "50 % of its tolerance");
  // As in reports/text/check_text_test.cpp.
  assert.equal(short_margin(0), "exact");
  assert.equal(short_margin(0.123), "12 %");
  assert.equal(short_margin(1), "100 %");
  assert.equal(short_margin(3.44), "3.4 ×");
  assert.equal(short_margin(320.4), "320 ×");
  assert.equal(short_margin(2.6e7), "3e+07 ×");
  assert.equal(short_margin(Infinity), "∞");
  assert.equal(short_margin(6.7e-13), "<0.01 %");
});

// The expected texts are those of reports/text/check_text_test.cpp.
test("a band says on which side of it a value lies", () => {
  const banded = (value, verdict) =>
    band_text(check({ value, expected: 0.3, band: [0.31, 0.35], verdict }));
  assert.equal(banded(0.32, "expected-shortfall"), "as expected in [0.31, 0.35] m");
  assert.equal(banded(3e5, "fail"), "worse than expected [0.31, 0.35] m");
  assert.equal(banded(0.28, "fail"), "worse than expected [0.31, 0.35] m");
  assert.equal(banded(0.3001, "fail"), "better than known [0.31, 0.35] m: raise the bar");
  assert.equal(banded(0.32, "fail"), "better than known [0.31, 0.35] m: raise the bar");
  assert.equal(banded("nan", "fail"), "no number where it is expected in [0.31, 0.35] m");
  assert.equal(band_text(check()), "");
});

test("the worst check decides as in judgement.h", () => {
  const near = check({ quantity: "near", of_tolerance: 0.9, verdict: "pass" });
  const bad = check({ quantity: "bad", of_tolerance: 1.1, verdict: "fail" });
  const shown = check({ quantity: "shown", of_tolerance: 1e12, verdict: "for-information" });
  assert.equal(worst_check([check(), near, shown], margin), near);
  assert.equal(worst_check([near, bad], margin), bad);
  assert.equal(worst_check([shown], margin), undefined);
});

// As reports/text/family_test.cpp has them.
test("families and natural order", () => {
  assert.equal(family_name("incline/threshold/mu=0.3/azimuth=30"), "incline/threshold");
  assert.equal(family_name("incline/mu=0.3"), "incline");
  assert.equal(family_name("single"), "single");
  assert.equal(short_name("incline/threshold/mu=0.3"), "mu=0.3");
  assert.deepEqual(
    natural_sort(["dt=1e-3", "dt=1e-4", "dt=10", "dt=9"], (x) => x),
    ["dt=1e-4", "dt=1e-3", "dt=9", "dt=10"],
  );
});

test("variants are told by what differs", () => {
  const of = (...settings) =>
    variant_labels(settings.map((one) => ({ run: "a", engine: "stiction", ...one })));
  assert.deepEqual(of({ rule: "none", dt: "1" }), [""]);
  assert.deepEqual(of({ rule: "none", dt: "1" }, { rule: "secant", dt: "1" }), ["none", "secant"]);
  assert.deepEqual(of({ rule: "none" }, { rule: "fixed-point", gain: "0.7" }), [
    "none",
    "fixed-point",
  ]);
  assert.deepEqual(of({ rule: "a" }, { rule: "a", gain: "0.7" }), ["", "gain=0.7"]);
  assert.deepEqual(of({ rule: "a" }, { rule: "a" }), ["#1", "#2"]);
  const methods = [
    { method: "old", rule: "none", weights: "t" },
    { method: "paper", rule: "fixed-point" },
    { method: "paper", rule: "secant", gain: "1" },
    { method: "quiet", rule: "stored-vector" },
  ];
  assert.deepEqual(of(...methods), ["old", "paper · fixed-point", "paper · secant", "quiet"]);
  // Only within a case must they be told apart: dt differs between the cases.
  const cases = [
    { rule: "none", dt: "1" },
    { rule: "secant", dt: "1" },
    { rule: "none", dt: "2" },
  ];
  assert.deepEqual(
    variant_labels(cases, (i) => (i < 2 ? "a" : "b")),
    ["none", "secant", "none"],
  );
});

test("two runs are compared by case, engine and settings", () => {
  const before = [
    record({ case: "a" }),
    record({ case: "b" }),
    record({ case: "gone" }),
    record({ case: "same" }),
  ];
  const after = [
    record({ case: "a", verdict: "fail", checks: [check({ verdict: "fail", digits: 1 })] }),
    record({
      case: "b",
      checks: [check({ digits: 2.5 })],
      cost: { ...record().cost, cpu_seconds: 0.5 },
    }),
    record({ case: "new" }),
    record({ case: "same", state_hash: "fedcba9876543210" }),
  ];
  const changes = compare(before, after);
  assert.deepEqual(
    changes.map((change) => [change.case, change.class]),
    [
      ["a", "worse"],
      ["gone", "gone"],
      ["b", "fewer-digits"],
      ["new", "new"],
      ["same", "same"],
    ],
  );
  assert.equal(changes[2].cost_ratio, 2);
  assert.equal(changes[2].digits_change, -1);
  assert.equal(changes[4].hash_equal, false);
});

test("what changes within noise is unchanged, with the reason", () => {
  const times = (cpu_seconds) => ({ ...record().cost, cpu_seconds });
  const of = (name, more) => record({ case: name, state_hash: name, ...more });
  const pair = (change_before, change_after) => {
    const steady = Array.from({ length: 10 }, (_, i) => of(`steady/${i}`, { cost: times(1) }));
    const [change] = compare(
      [...steady, of("a", change_before)],
      [...steady, of("a", change_after)],
    ).filter((one) => one.case === "a");
    return change;
  };
  const digits = (value, of_tolerance = 0.5) => ({
    checks: [check({ digits: value, of_tolerance })],
  });
  assert.equal(pair({}, {}).class, "same");
  assert.equal(same_reason(pair({}, {})), "end-state");
  assert.equal(pair(digits(3.5), { ...digits(3.3), state_hash: "b" }).class, "same");
  assert.equal(same_reason(pair(digits(3.5), { ...digits(3.3), state_hash: "b" })), "digits");
  assert.equal(pair(digits(3.5), digits(3.1)).class, "fewer-digits");
  assert.equal(pair(digits(12, 1e-5), digits(9, 1e-3)).class, "same", "below 1 % both times");
  assert.equal(pair({ cost: times(1) }, { cost: times(1.14) }).class, "same");
  assert.equal(pair({ cost: times(1) }, { cost: times(1.2) }).class, "slower");
  assert.equal(pair({ cost: times(1) }, { cost: times(0.8) }).class, "faster");
  assert.equal(pair({ cost: times(0.01) }, { cost: times(0.03) }).class, "same", "too short");
});

test("the noise of CPU times is their spread, about what the median pair takes", () => {
  const even = cost_noise([0.9, 0.95, 1, 1, 1.05, 1.1, 1, 0.98, 1.3]);
  assert.ok(even.median === 1 && even.factor > 1.15 && even.factor < 1.35, JSON.stringify(even));
  assert.deepEqual(cost_noise([2, 3]), { median: 1, factor: 1.15, pairs: 2 });
  assert.equal(cost_noise(Array(9).fill(1.5)).median, 1.5);
});

test("where nothing says of what size zero is, tolerances are compared", () => {
  const of = (of_tolerance) =>
    record({ checks: [check({ expected: 0, scale: undefined, digits: undefined, of_tolerance })] });
  const [{ digits_change }] = compare([of(1e-2)], [of(1e-1)]);
  assert.ok(Math.abs(digits_change + 1) < 1e-12);
  assert.equal(compare([of(1e-9)], [of(1e-4)])[0].class, "same", "far below what decides");
  assert.equal(compare([of(0)], [of(1e-4)])[0].class, "same");
});

test("a record's digits are the fewest of its checks that pass or fail", () => {
  const of = (...checks) => fewest_digits(record({ checks }));
  const zero = check({ expected: 0, digits: undefined });
  assert.equal(of(check({ digits: 4 }), zero, check({ digits: 1, verdict: "refuted" })), 4);
  assert.equal(of(zero), null);
});

test("addresses survive every name", () => {
  for (const name of ["incline/mu=0.3", "a&b#c%d e", "100%", "<img>", "日本", "=", "&", "?"]) {
    assert.equal(parse_hash(hash_of("case", name)).value, name);
    assert.deepEqual(parse_hash(hash_of("cases", "", { q: name, verdict: "fail" })).options, {
      q: name,
      verdict: "fail",
    });
  }
  assert.equal(parse_hash("").view, "summary");
  assert.equal(parse_hash("#case=%zz").value, "%zz");
});

test("rows are filtered and sorted", () => {
  const row = (index, change) => ({
    index,
    run: 0,
    case: `case/${index}`,
    family: "case",
    title: "",
    engine: "e",
    variant: "rule=none",
    verdict: "pass",
    seconds: 1,
    ns: 0,
    check: { quantity: "creep", margin: index, digits: 3 },
    column: "quiet",
    configuration: "quiet",
    quantities: "creep\ndrift",
    ...change,
  });
  const rows = [
    row(0),
    row(1, { verdict: "fail" }),
    row(2, { check: null }),
    row(3, {
      check: { quantity: "slip", margin: Infinity, digits: NaN },
      quantities: "slip\nkinetic energy",
      column: "old",
    }),
  ];
  const indices = (list) => list.map(({ index }) => index);
  assert.deepEqual(indices(filtered(rows, { q: "CASE creep" })), [0, 1, 2]);
  assert.deepEqual(indices(filtered(rows, { q: "drift" })), [0, 1, 2], "not the worst check's");
  assert.deepEqual(indices(filtered(rows, { q: "kinetic" })), [3]);
  assert.deepEqual(indices(filtered(rows, { configuration: "old" })), [3]);
  assert.deepEqual(indices(filtered(rows, { verdict: "fail,error" })), [1]);
  assert.deepEqual(indices(sorted(rows, "verdict")), [1, 0, 2, 3]);
  assert.deepEqual(indices(sorted(rows, "-margin")), [3, 1, 0, 2]);
  assert.deepEqual(indices(sorted(rows, "no such column")), [0, 1, 2, 3]);
});

test("a time stands between two frames", () => {
  const times = [0, 0.1, 0.4];
  assert.deepEqual(place_at(times, -1), { frame: 0, part: 0 });
  assert.deepEqual(place_at(times, 9), { frame: 2, part: 0 });
  assert.equal(place_at(times, 0.25).frame, 1);
  assert.ok(Math.abs(place_at(times, 0.25).part - 0.5) < 1e-12);
});

// A body of two vertices that moves by `way` m a frame, with a contact of `forces[i]` N in frame i.
const recording_of = (way, forces) => ({
  bodies: [{ name: "body", vertices: 2, triangles: [] }],
  times: forces.map((_, i) => i),
  ups: forces.map(() => [0, 0, 1]),
  frame: (i) => ({
    positions: Float32Array.of(way * i, 0, 0, way * i + 1, 1, 1),
    contacts: [{ normal_force: [0, 0, forces[i]], friction_force: [0, 0, 0], sticks: true }],
  }),
});

test("the camera shows the whole way, but not what flies off; an impact does not shrink the arrows", () => {
  const near = recording_of(1, [1, 2, 900]);
  const far = recording_of(40, [3, 3, 3]);
  const { centre, radius } = view_of([near]);
  assert.ok(
    Math.abs(centre[0] - 1.5) < 1e-6 && radius > 1.5 && radius < 2,
    `${centre[0]}, ${radius}`,
  );
  assert.equal(view_of([near]).force, 2);
  const both = view_of([near, far]);
  assert.ok(Math.abs(both.centre[0] - 1.5) < 1e-6, "it stays with the one that stays");
  assert.ok(both.radius < 1.5 * radius + 1e-6);
  assert.equal(view_of([near, far]).force, 2);
});

test("between two frames bodies and the way up go on evenly", () => {
  const recording = {
    ...recording_of(1, [1, 2]),
    ups: [
      [0, 0, 1],
      [1, 0, 1],
    ],
  };
  const { positions, up, contacts } = instant(recording, 0.25);
  assert.equal(positions[0], 0.25);
  assert.deepEqual(up, [0.25, 0, 1]);
  assert.equal(contacts[0].normal_force[2], 1);
});
