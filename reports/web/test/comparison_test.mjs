// SPDX-License-Identifier: GPL-3.0-or-later
// Comparisons: what records mean, and what the plots make of them.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  chief_quantity,
  failed_values,
  failure_of,
  failure_text,
  figure_of,
  figure_text,
  is_comparison,
} from "../model/figure.js";
import { by_topic, parted } from "../model/finding.js";
import { rule_words, rules_on_contacts } from "../model/rule.js";
import { log_place, moved_apart } from "../plots/end_labels.js";
import { is_history } from "../plots/history_plot.js";
import { case_plots, comparison_scores, family_plots } from "../plots/plots.js";
import { is_rule_work } from "../plots/rule_work_plot.js";
import { cut_words } from "../plots/variant_channels.js";
import { compared_records, figure, FINDINGS } from "./compared_records.mjs";
import { check, record } from "./records.mjs";

const RUNS = [{ role: "shown", short: "a", date: "2025-11-20T00:00:00Z" }];
const entries_of = (wanted) =>
  compared_records()
    .filter((one) => wanted.test(one.case))
    .map((one) => ({ record: one, run: 0 }));
const layers_with = (plot, field) =>
  plot.spec.layer.filter(({ data }) => data.values.some((value) => field in value));

test("records with figures are those of a comparison", () => {
  assert.ok(
    !is_comparison([record(), record({ checks: [check({ verdict: "for-information" })] })]),
  );
  assert.ok(is_comparison(compared_records()));
});

test("figures in words: what was never reached, what was not measured", () => {
  assert.equal(figure_text(Infinity), "never");
  assert.equal(figure_text(NaN), "–");
  assert.equal(figure_text(2638), "2638");
  assert.equal(figure_text(4.6412e-19), "4.64e-19");
  assert.equal(
    figure_of(record({ figures: [figure("slipped", "m", "inf")] }), "slipped"),
    Infinity,
  );
  assert.ok(Number.isNaN(figure_of(record(), "stopping distance")));
});

test("a case is told by its first figure with a unit, beside measured work by the other", () => {
  const of = (...figures) => chief_quantity([record({ figures })]).quantity;
  assert.equal(of(figure("steps", "1", 3), figure("creep", "m/s", 1)), "creep");
  assert.equal(of(figure("steps", "1", 3)), "steps");
  assert.equal(of(figure("share", "1", 3), figure("CPU time", "s", 1)), "share");
});

test("a record fails as a whole; values of a parameter that fail are not the record's", () => {
  const whole = { reason: "a body moved by 7.6 mm", parameter: "", values: [] };
  const part = { reason: "it broke", parameter: "gain", values: [-0.5, 2.3] };
  const failing = (...failures) => record({ failures });
  assert.equal(failure_of(failing(part, whole)), "a body moved by 7.6 mm");
  assert.equal(failure_of(failing(part)), "");
  assert.equal(failure_text(part), "it broke at gain = -0.5, 2.3");
  assert.deepEqual(failed_values(failing(part), "gain"), [-0.5, 2.3]);
  assert.deepEqual(failed_values(failing(part), "alpha"), []);
  assert.equal(failure_of(record({ verdict: "error", error: "timed out" })), "timed out");
});

// The words of validation/comparison/comparison_test.cpp and of the findings.
test("rules are called as the findings call them", () => {
  const words = (variant, settings) => rule_words({ variant, settings });
  const resolved = { rule: "secant", gain: "0.7", memory: "reset", safeguard: "on" };
  assert.equal(words("method=paper rule=secant", resolved), "secant");
  assert.equal(words("", resolved), "secant");
  assert.equal(
    words("depth=projection memory=keep method=paper rule=secant safeguard=off", resolved),
    "secant, memory = keep, safeguard = off",
  );
  assert.equal(
    words("method=paper rule=new-rule stiffness=3", { rule: "new-rule", stiffness: "3" }),
    "new-rule, stiffness = 3",
  );
  assert.equal(
    words("method=quiet rule=stored-vector sweeps=4", { rule: "stored-vector", sweeps: "4" }),
    "stored-vector, 4 sweeps",
  );
  assert.equal(
    words("method=quiet rule=conjugate-vector", { rule: "conjugate-vector", sweeps: "64" }),
    "conjugate-vector, at most 64 sweeps",
  );
  assert.equal(
    words("build=single method=paper rule=secant", { rule: "secant", build: "single" }),
    "secant, single precision",
  );
});

test("variants are named in short where that is enough, and never alike", () => {
  const variant_of = ({ rule, memory }) =>
    [memory && `memory=${memory}`, `rule=${rule}`].filter(Boolean).join(" ");
  const of = (...settings) =>
    rules_on_contacts(settings.map((one) => record({ settings: one, variant: variant_of(one) })));
  const told = of(
    { rule: "conjugate-vector", sweeps: "64", method: "paper" },
    { rule: "secant", method: "paper" },
    { rule: "secant", memory: "keep", method: "paper" },
    { rule: "secant", method: "quiet" },
    { rule: "secant", method: "quiet", key: "body" },
  );
  assert.deepEqual(
    told.map(({ name }) => name),
    ["conjugate-vector", "secant", "secant, memory = keep", "secant", "secant #2"],
  );
  assert.equal(told[2].label, "secant, memory = keep · paper");
  const quiet = { rule: "conjugate-vector", sweeps: "64", method: "quiet" };
  assert.deepEqual(
    of(quiet, { ...quiet, build: "single" }).map(({ name }) => name),
    ["conjugate-vector", "conjugate-vector, single precision"],
  );
});

test("names beside curves keep their order and their distance, within the plot", () => {
  const moved = moved_apart([50, 10, 11, 12, 300], 13, 200);
  assert.deepEqual(
    [...moved.keys()].sort((a, b) => moved[a] - moved[b]),
    [1, 2, 3, 0, 4],
  );
  const sorted = [...moved].sort((a, b) => a - b);
  for (let i = 1; i < sorted.length; ++i) assert.ok(sorted[i] - sorted[i - 1] >= 13 - 1e-9);
  assert.ok(sorted[0] >= 0 && sorted.at(-1) <= 200);
  assert.deepEqual(moved_apart([100], 13, 200), [100]);
  const tight = moved_apart([5, 5, 5, 5, 5], 13, 40).sort((a, b) => a - b);
  assert.deepEqual(tight, [0, 10, 20, 30, 40]);
  assert.equal(log_place(1e-2, [1e-4, 1], 100), 50);
});

test("histories: every variant is drawn, both axes are logarithmic, failures are marked", () => {
  const plots = case_plots("rules/membrane", entries_of(/^rules\/membrane$/), RUNS);
  assert.deepEqual(
    plots.map(({ kind, title }) => [kind, title]),
    [
      ["history", "mean contact slip on paper contacts, step by step"],
      ["history", "mean contact slip on quiet contacts, step by step"],
    ],
  );
  for (const plot of plots) {
    const [lines] = plot.spec.layer;
    assert.equal(new Set(lines.data.values.map(({ curve_key }) => curve_key)).size, 7);
    assert.equal(lines.encoding.x.scale.type, "log");
    assert.equal(lines.encoding.y.scale.type, "log");
    const names = layers_with(plot, "label_place")
      .at(-1)
      .data.values.map(({ name }) => name);
    assert.equal(names.length, 7);
    assert.ok(names.includes("✕ secant") && names.includes("fixed-point, memory = keep"));
    assert.match(plot.caption, /1 of 7 that fail/);
  }
  const domain = (plot) => plot.spec.layer[0].encoding.y.scale.domain;
  assert.deepEqual(domain(plots[0]), domain(plots[1]));
  assert.match(
    case_plots("rules/ball", entries_of(/^rules\/ball$/), RUNS)[0].caption,
    /All 7 fail/,
  );
  assert.ok(!is_history({ x: [0.1, 0.2], x_unit: "1" }));
  assert.ok(!is_history({ x: [0, 1], x_unit: "1" }));
});

test("sweeps: negative values of the parameter, a logarithmic figure, failures at the edge", () => {
  const [plot] = case_plots("gain/slab", entries_of(/^gain/), RUNS);
  assert.equal(plot.kind, "sweep");
  const [lines] = plot.spec.layer;
  assert.deepEqual(lines.encoding.x.scale.domain, [-0.5, 2.5]);
  assert.equal(lines.encoding.x.scale.type, "linear");
  assert.equal(lines.encoding.y.scale.type, "log");
  const [, top] = lines.encoding.y.scale.domain;
  const crosses = layers_with(plot, "failure").at(-1).data.values;
  assert.deepEqual(
    crosses.map(({ x, y }) => [x, y]),
    [
      [-0.5, top],
      [2.5, top],
    ],
  );
  assert.match(plot.caption, /fixed-point 0\.00001 at 0; secant 0\.00002 at 0/);
});

test("work and precision: a line a variant and mesh, the front, failures at the upper edge", () => {
  const entries = entries_of(/^work/);
  assert.ok(is_rule_work(entries.map((one) => one.record)));
  assert.ok(!is_rule_work(entries_of(/^rules/).map((one) => one.record)));
  const plots = family_plots("work/slab", entries, RUNS);
  assert.deepEqual(
    plots.map(({ kind }) => kind),
    ["work-precision", "work-precision", "work-precision"],
  );
  const [overall] = plots;
  const [lines, points, crosses, front] = overall.spec.layer.map(({ data }) => data.values);
  assert.equal(lines.length + crosses.length, entries.length);
  assert.deepEqual(points, lines);
  assert.equal(new Set(lines.map(({ line_key }) => line_key)).size, 28);
  assert.equal(crosses.length, 4);
  const [, top] = overall.spec.layer[0].encoding.y.scale.domain;
  for (const { y, failure } of crosses) assert.deepEqual([y, failure], [top, "the box slid off"]);
  // Whatever is cheapest begins the front; the most precise at its least cost ends it.
  assert.equal(front[0].x, Math.min(...lines.map(({ x }) => x)));
  const least = Math.min(...lines.map(({ y }) => y));
  assert.equal(front.at(-1).y, least);
  assert.equal(front.at(-1).x, Math.min(...lines.filter(({ y }) => y === least).map(({ x }) => x)));
  assert.match(overall.caption, /56 runs.*values of dt.*4 failed/);
});

test("work a simulated second: its unit, and what broke is on no front however cheap and precise", () => {
  const entries = [
    ["2e-4", 0.02, 1e-5, ""],
    ["1e-4", 0.04, 1e-7, ""],
    ["5e-4", 0.001, 1e-12, "it did not hold"],
  ].map(([dt, seconds, error, reason]) => ({
    record: record({
      case: `work-precision/creep/cells=2/dt=${dt}`,
      settings: { method: "quiet", rule: "conjugate-vector", dt },
      checks: [],
      figures: [figure("error at most", "m/s", error), figure("CPU time", "s/s", seconds)],
      failures: reason ? [{ reason, parameter: "", values: [] }] : [],
    }),
    run: 0,
  }));
  const [overall] = family_plots("work-precision/creep", entries, RUNS);
  const [lines, , crosses, front] = overall.spec.layer.map(({ data }) => data.values);
  assert.equal(lines.length, 2);
  assert.deepEqual(
    crosses.map(({ failure }) => failure),
    ["it did not hold"],
  );
  assert.deepEqual(
    front.map(({ y }) => y),
    [1e-5, 1e-7],
  );
  assert.match(overall.spec.layer[0].encoding.x.axis.title, /CPU time.*s\/s/);
  assert.match(overall.description, /s\/s/);
});

test("what broke off before it was timed is drawn too", () => {
  const entries = entries_of(/^work/);
  entries[0].record = {
    ...entries[0].record,
    verdict: "error",
    error: "timed out",
    checks: [],
    figures: [],
    cost: { ...record().cost, cpu_seconds: 0 },
  };
  const [overall] = family_plots("work/slab", entries, RUNS);
  const crosses = overall.spec.layer[2].data.values;
  const broken = crosses.find(({ failure }) => failure === "timed out");
  assert.ok(broken.x > 0);
  assert.equal(crosses.length, 5);
});

test("rules by case: best rule on top, least of a column marked, failures crossed", () => {
  const entries = entries_of(/^(rules|gain|work)/);
  const scores = comparison_scores(entries, RUNS);
  assert.deepEqual(
    scores.map(({ folder }) => folder),
    ["rules"],
  );
  const [paper, quiet] = scores[0].plots;
  assert.match(paper.title, /^final creep \(m\/s\) on paper contacts/);
  assert.match(quiet.title, /quiet/);
  const cells = paper.spec.layer[0].data.values;
  assert.equal(cells.length, 7 * 4);
  const best = cells.filter((cell) => cell.best);
  assert.deepEqual(
    best.map((cell) => [cell.case, cell.rule, cell.row_key]),
    ["slab", "clamp", "membrane"].map((scene) => [
      `rules/${scene}`,
      "fixed-point, memory = keep",
      0,
    ]),
  );
  assert.equal(cells.filter(({ text }) => text === "✕").length, 7 + 1);
});

test("findings: a lead each, those of single cases apart", () => {
  assert.deepEqual(parted(FINDINGS[2]), ["rules/slab:", " 1e-9 m/s within 50 steps by none."]);
  assert.deepEqual(parted(FINDINGS[1]), ["", "No rule beats both."]);
  assert.deepEqual(by_topic(FINDINGS), [
    ["", FINDINGS.slice(0, 2)],
    ["rules", FINDINGS.slice(2)],
  ]);
  assert.deepEqual(by_topic([]), []);
});

test("a plot that leaves variants out says so", () => {
  assert.equal(cut_words(7), "");
  assert.match(cut_words(9), /^7 of 9 variants, the first of each configuration/);
});
