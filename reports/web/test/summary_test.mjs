// SPDX-License-Identifier: GPL-3.0-or-later
// The answer in short: what the summary says of configurations, and what its plots and words rest on.
import assert from "node:assert/strict";
import { test } from "node:test";
import { winners_of } from "../make/winners.mjs";
import { is_of_creep, summary_of } from "../make/summary.mjs";
import { GLOSSARY, glossary_entry } from "../model/glossary.js";
import { OWN_CONFIGURATIONS } from "../model/configuration.js";
import { VERDICT_WORDS } from "../model/verdict.js";
import { effort_groups, shared_cases, work_points } from "../model/work.js";
import { clear_power_law } from "../plots/fit.js";
import { is_size, parameter_plot } from "../plots/parameter_plot.js";
import { series_plot } from "../plots/series_plot.js";
import { judges, tolerance_rules } from "../plots/tolerance_rules.js";
import { work_precision_plot } from "../plots/work_precision_plot.js";
import { check, record } from "./records.mjs";

const creep = (value, verdict, of_tolerance) =>
  check({
    quantity: "creep",
    unit: "m/s",
    value,
    expected: 0,
    error: value,
    relative: false,
    scale: undefined,
    digits: undefined,
    tolerance: 1e-9,
    of_tolerance,
    verdict,
    because: verdict === "refuted" ? "one scalar leaves slip" : "",
  });
const one = (name, configuration, verdict, checks, more = {}) =>
  record({ case: name, configuration, verdict, checks, ...more });
const cost = (cpu_seconds) => ({ cost: { ...record().cost, cpu_seconds } });

const RECORDS = [
  one("slab/rest/a", "quiet", "pass", [creep(1e-12, "pass", 1e-3)], cost(1)),
  one("slab/rest/a", "paper, secant", "refuted", [creep(1e-3, "refuted", 1e6)], cost(2)),
  one("slab/rest/b", "quiet", "pass", [check({ of_tolerance: 0.9 })], cost(3)),
  one("drop/ball", "quiet", "pass", [check()], cost(4)),
  one("drop/ball", "paper, secant", "error", [], cost(0.5)),
  one("drop/skipped", "old", "not-applicable", []),
];

test("the table has a cell for each configuration and family, and families that fall short come first", () => {
  const { configurations, families, shared, causes } = summary_of(RECORDS);
  assert.deepEqual(
    configurations.map(({ name }) => name),
    ["quiet", "paper, secant"],
  );
  const [quiet, secant] = configurations;
  assert.deepEqual(quiet.counts, [["pass", 3]]);
  assert.equal(quiet.worst.margin, 0.9);
  assert.equal(quiet.seconds, 8);
  assert.deepEqual([quiet.creep.looked, quiet.creep.creeping], [1, 0]);
  assert.deepEqual([secant.creep.looked, secant.creep.creeping], [1, 1]);
  assert.equal(secant.creep.fastest.value, 1e-3);
  assert.equal(secant.broke, 1);
  assert.deepEqual(
    families.map(({ name, all_hold }) => [name, all_hold]),
    [
      ["drop/ball", false],
      ["slab/rest", false],
    ],
  );
  assert.deepEqual(families[1].cells[0].counts, [["pass", 2]]);
  assert.deepEqual(shared, { cases: 2, configurations: 2 });
  assert.deepEqual(causes, [
    {
      because: "one scalar leaves slip",
      records: 1,
      configurations: ["paper, secant"],
      case: "slab/rest/a",
    },
  ]);
  assert.equal(summary_of([record({ verdict: "not-applicable", checks: [] })]), null);
});

test("with several engines a column names both, and ours keeps its own", () => {
  const of = (engine, configuration) => record({ engine, configuration });
  const names = summary_of([of("stiction", "quiet"), of("bullet", "best"), of("ode", "default")]);
  assert.deepEqual(
    names.configurations.map(({ name }) => name),
    ["quiet", "bullet · best", "ode · default"],
  );
});

test("creep is told from other slips", () => {
  const of = (quantity, unit) => is_of_creep({ quantity, unit });
  assert.ok(of("fastest contact slip", "m/s") && of("drift at rest", "m") && of("creep", "m/s"));
  assert.ok(!of("slip length", "m") && !of("speed after 1 s", "m/s") && !of("creep", "1"));
});

test("configurations are summed up over the most cases that the most of them share", () => {
  const pair = (configuration, ...names) => names.map((name) => ({ case: name, configuration }));
  const five = ["1", "2", "3", "4", "5"];
  const shared = shared_cases([
    ...pair("a", ...five, "6", "7"),
    ...pair("b", ...five, "6", "7"),
    ...pair("c", ...five),
    ...pair("d", "1"),
  ]);
  assert.deepEqual(shared.configurations.sort(), ["a", "b", "c"]);
  assert.equal(shared.cases.length, 5);
  assert.deepEqual(shared_cases(pair("a", "1", "2")).cases, []);
});

test("a line joins records that differ in their effort only", () => {
  const of = (settings, seconds) => record({ configuration: "quiet", settings, ...cost(seconds) });
  const groups = effort_groups(
    work_points([
      of({ dt: "1e-4", kappa: "1" }, 4),
      of({ dt: "2e-4", kappa: "1" }, 2),
      of({ dt: "1e-4", kappa: "0.7" }, 4),
    ]),
  );
  assert.equal(groups.length, 1);
  assert.deepEqual(
    groups[0].map(({ seconds }) => seconds),
    [2, 4],
  );
});

test("what broke off stands in a strip of its own, and what is clipped says so", () => {
  const plot = work_precision_plot(
    [...RECORDS, one("slab/rest/c", "quiet", "fail", [creep(1, "fail", 1e9)], cost(1))],
    { always: true },
  );
  const values = plot.spec.layer.flatMap(({ data }) => data.values);
  const of = (name, configuration) =>
    values.find((value) => value.case === name && value.configuration === configuration);
  assert.ok(of("drop/ball", "paper, secant").place > 6.5);
  assert.equal(of("slab/rest/c", "quiet").place, 6);
  assert.equal(of("slab/rest/c", "quiet")["error ÷ tolerance"], "1000000000 × tolerance");
  const { axis } = plot.spec.layer[0].encoding.y;
  assert.match(axis.labelExpr, /≥ 1e6/);
  assert.match(axis.labelExpr, /broke off/);
});

test("a power law is fitted only where there is one to fit", () => {
  const points = (ys, xs = [1, 2, 4, 8]) => xs.map((x, i) => ({ x, y: ys[i] }));
  assert.equal(clear_power_law(points([1, 4, 16, 64])).exponent.toFixed(6), "2.000000");
  assert.equal(clear_power_law(points([1, 4, 3, 64])), null, "not monotone");
  assert.equal(clear_power_law(points([1, 1.01, 1.02, 90])), null, "far from a line");
  assert.equal(clear_power_law(points([1, 2], [1, 2])), null, "two points");
  assert.equal(clear_power_law(points([5, 5, 5, 5])), null, "hardly changes");
  assert.equal(clear_power_law(points([0, 1, 2, 3])), null, "not positive");
  const over = (x_name, x_unit) => ({ x_name, x_unit });
  for (const name of ["configuration", "ingredient", "seed", "step", "throw"])
    assert.equal(is_size(over(name, "1")), false, name);
  for (const [name, unit] of [
    ["contacts", "1"],
    ["resolution in space", "1"],
    ["Young's modulus", "Pa"],
  ])
    assert.equal(is_size(over(name, unit)), true, name);
  const series = { ...over("configuration", "1"), name: "slip", unit: "m/s" };
  const plot = parameter_plot([
    { label: "", configuration: "quiet", series: { ...series, x: [1, 2, 4], y: [1, 2, 4] } },
  ]);
  assert.doesNotMatch(plot.caption, /exponent/);
});

test("the marks of seven configurations all show where they are filled", () => {
  const series = { name: "step per contact", unit: "s", x_name: "contacts", x_unit: "1" };
  const curves = [1, 2, 3, 4, 5, 6, 7].map((k) => ({
    label: "",
    configuration: `way ${k}`,
    series: { ...series, x: [100, 1000], y: [k, k] },
  }));
  const { spec } = parameter_plot(curves);
  const layer = spec.layer.find(({ mark }) => mark.type === "point" && mark.filled);
  const shapes = layer.encoding.shape.scale.range;
  assert.equal(new Set(shapes).size, 7);
  // Vega's "stroke" is a line: filled, it covers nothing.
  assert.ok(!shapes.includes("stroke"), shapes.join(" "));
  const bar = shapes.find((shape) => shape.startsWith("M"));
  assert.match(bar, /^M-1.2,-0.25H1.2V0.25H-1.2Z$/);
});

test("the tolerance of a check is drawn in the plot of what it judges", () => {
  const series = {
    ...{ name: "creep", unit: "m/s", x_name: "time", x_unit: "s" },
    ...{ x: [1, 2, 3], y: [1e-3, 1e-6, 1e-12] },
  };
  const of = (quantity, unit = "m/s") => ({ quantity, unit });
  assert.ok(judges(of("creep"), series) && judges(of("creep at rest"), series));
  assert.ok(judges(of("creep"), { ...series, name: "creep (last)" }));
  assert.ok(!judges(of("creep", "m"), series) && !judges(of("creep of the box"), series));
  const curve = { label: "", configuration: "quiet", series, record: RECORDS[0] };
  assert.deepEqual(
    tolerance_rules([curve], true).map(({ y }) => y),
    [1e-9],
  );
  const plot = series_plot([curve]);
  const rules = plot.spec.layer.filter(({ mark }) => mark.type === "rule");
  assert.equal(rules[0].data.values[0].y, 1e-9);
  assert.match(plot.caption, /what the check allows/);
  const [low, high] = plot.spec.layer[0].encoding.y.scale.domain;
  assert.ok(low <= 1e-12 && high >= 1e-3);
});

test("values that are no numbers are counted in the caption, not silently left out", () => {
  const series = {
    ...{ name: "energy", unit: "J", x_name: "time", x_unit: "s" },
    ...{ x: [1, 2, 3], y: [1, "nan", "inf"] },
  };
  const { caption } = series_plot([{ label: "", configuration: "old", series, record: record() }]);
  assert.match(caption, /2 values are no finite number/);
});

test("each verdict and configuration has its entry in the glossary, and no entry stands twice", () => {
  for (const word of [...Object.values(VERDICT_WORDS), ...OWN_CONFIGURATIONS, "κ", "ξ", "creep"])
    assert.ok(glossary_entry(word)?.meaning, word);
  const names = GLOSSARY.map(({ name }) => name);
  assert.equal(new Set(names).size, names.length);
  assert.equal(glossary_entry("toString"), undefined);
});

test("each scene of a comparison has its winner, with what is just as good and the next", () => {
  const entry = (name, rule, creeps, failed = false) => ({
    record: record({
      case: name,
      figures: [{ quantity: "final creep", unit: "m/s", meaning: "", value: creeps }],
      failures: failed ? [{ reason: "it fell", parameter: "", values: [] }] : [],
    }),
    variant: { name: rule, contacts: "" },
  });
  const { questions, scenes } = winners_of([
    entry("rules/a", "best", 1e-12),
    entry("rules/a", "good", 1e-6),
    entry("rules/a", "broken", 0, true),
    entry("rules/b", "best", 0),
    entry("rules/b", "good", 0),
    entry("rules/c", "best", "inf"),
  ]);
  const [a, b, c] = scenes.map(({ answers }) => answers[0]);
  assert.equal(a.winner.label, "best");
  assert.equal(a.second.label, "good");
  assert.deepEqual([b.ties, b.second], [1, null]);
  assert.equal(c.winner, null);
  assert.deepEqual(questions[0].wins, [{ label: "best", count: 2 }]);
});
