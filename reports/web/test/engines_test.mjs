// SPDX-License-Identifier: GPL-3.0-or-later
// Engines side by side: what the records mean, and what the summary makes of them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { builds_beside } from "../model/build_pairs.js";
import { cheapest_ways, points_of } from "../model/cheapest_way.js";
import {
  case_of_command,
  command_of,
  compared_variants,
  is_answer,
  own_labels,
  record_labels,
} from "../model/engine.js";
import { answer_of, failed_efforts, short_error } from "../model/engine_answer.js";
import { whole_questions } from "../model/engine_question.js";
import { page_data } from "../make/page_data.mjs";
import { engine_work_plot } from "../plots/engine_work_plot.js";
import {
  ENGINE_FINDINGS,
  engine_records,
  kind_of,
  QUESTIONS,
  row_name,
  ROWS,
} from "./engine_records.mjs";
import { record } from "./records.mjs";

const all = engine_records();
const of_question = (id) => all.filter((one) => one.case === `engines/${id}`);
const data_of = (...runs) =>
  page_data({
    runs: runs.map((records, i) => ({ name: `2025-11-20T00-00-0${i}Z`, records })),
    against: [],
    title: "engines",
    warnings: [],
  });

// As short_error() of validation/comparison/engines/engine_matrix.cpp prints them.
test("errors in short, signed where they can be below 0", () => {
  for (const [error, unit, text] of [
    [0, "°", "0"],
    [NaN, "°", "never"],
    [-2.749e-5, "°", "-3e-5"],
    [-0.00245, "1", "-0.0024"],
    [0.0012, "1", "+0.0012"],
    [4.2e-13, "m/s", "4.2e-13"],
    [0.5, "m/s", "5.0e-1"],
    [3.14, "1", "+3.1"],
    [12, "°", "+12"],
    [-1234, "1", "-1.2e+3"],
    [2, "", "+2"],
  ])
    assert.equal(short_error(error, unit), text);
});

test("a question that goes on with the one before becomes a whole sentence", () => {
  const asked = (...list) =>
    whole_questions(list.map(([id, title]) => ({ id, title, case_title: "a cube rests" })));
  const creep = ["creep-0", "Does it creep? Falling to 0°"];
  const more = ["creep-30", "… falling to 30°"];
  assert.deepEqual(asked(creep, more), [creep[1], "Does it creep? Falling to 30°"]);
  assert.deepEqual(asked(more), ["A cube rests"]);
  assert.deepEqual(asked(["stops", "How far?"], more), ["How far?", "A cube rests"]);
});

test("an answer is told, never there, broken or lacking, and says why", () => {
  QUESTIONS.forEach(({ id }, question) =>
    of_question(id).forEach((one, row) =>
      assert.equal(answer_of(one).kind, kind_of(row, question)),
    ),
  );
  const lacking = all.find(
    ({ verdict, case: name }) => verdict === "not-applicable" && name.startsWith("engines/"),
  );
  assert.equal(answer_of(lacking).why, "the engine turns no bodies");
  assert.deepEqual(failed_efforts(lacking), []);
  const broken = all.find(
    (one) => one.case.startsWith("engines/") && answer_of(one).kind === "broke",
  );
  assert.match(answer_of(broken).why, /^it was killed by signal 11/);
});

test("records are called engine · configuration, and by effort where there are several", () => {
  const answers = all.filter((one) => one.case === QUESTIONS[4].case_name);
  assert.ok(answers.every(is_answer));
  assert.equal(record_labels(answers, () => "")[0], "bullet · default · effort 0");
  assert.equal(own_labels([record(), answers[1]])[1], "bullet · default");
  assert.equal(own_labels([record(), answers[1]])[0], "");
  const [first] = compared_variants(of_question("question-0"));
  assert.deepEqual(first, {
    rule: "bullet",
    words: "bullet · default",
    name: "bullet · default",
    contacts: "",
    label: "bullet · default",
  });
});

test("the command and the case that it asks", () => {
  const command = command_of(of_question("question-3")[0]);
  assert.match(command, /^\.\/stiction validate --engine 'bullet'/);
  assert.equal(case_of_command(command), "slope/scene-3/azimuth=3");
  assert.equal(command_of(record()), "");
});

test("the cheapest way: of others and ours, bounds with the same ways in one row", () => {
  const curve = (engine, x, y) => ({
    name: `${engine} · default`,
    record: record({ engine, series: [{ name: "error", x, y }] }),
  });
  const rows = cheapest_ways(
    points_of([
      curve("ode", [1, 2], [1e-3, 1e-5]),
      curve("dart", [0.5, 8], ["nan", 1e-3]),
      curve("stiction", [4], [0]),
    ]),
  );
  const ours = { name: "stiction · default", seconds: 4 };
  const theirs = (seconds) => ({ name: "ode · default", seconds });
  assert.deepEqual(rows, [
    { bounds: [1e-2], theirs: theirs(1), ours, ratio: 4 },
    { bounds: [1e-4], theirs: theirs(2), ours, ratio: 2 },
    { bounds: [1e-6], theirs: null, ours, ratio: null },
  ]);
});

test("one picture of all engines: curves, what none beats, failures named", () => {
  const records = of_question("question-4");
  const variants = compared_variants(records);
  const plot = engine_work_plot(records.map((one, i) => ({ record: one, variant: variants[i] })));
  const [front, lines, , failed] = plot.spec.layer.map(({ data }) => data.values);
  const lacking = records.filter((one) => answer_of(one).kind === "lacks").length;
  assert.equal(new Set(lines.map(({ who }) => who)).size, ROWS.length - lacking);
  assert.ok(front.length > 1);
  front.slice(1).forEach(({ y }, i) => assert.ok(y < front[i].y));
  assert.equal(failed.length, records.flatMap(failed_efforts).length);
  assert.match(failed[0].name, /^✕ dart · dantzig, effort 3$/);
  assert.match(plot.caption, /On the upper edge: it never came/);
  assert.equal(engine_work_plot([{ record: record(), variant: variants[0] }]), null);
});

const beside = (engine, errors, more = {}) => ({
  name: `${engine} · quiet`,
  record: record({
    case: "engines/a",
    engine,
    settings: { configuration: "quiet", ...more },
    verdict: "for-information",
    figures: [
      { quantity: "error", unit: "1", meaning: "relative", value: errors[0] },
      { quantity: "CPU time", unit: "s", meaning: "", value: 1 },
    ],
    failures: errors.flatMap((error, k) =>
      error === null ? [{ reason: "it broke", parameter: "effort", values: [k] }] : [],
    ),
    series: [
      {
        name: "error",
        unit: "1",
        x: errors.flatMap((error, k) => (error === null ? [] : [2 ** k])),
        y: errors.filter((error) => error !== null),
      },
    ],
  }),
});
const precisions = () => [
  beside("stiction", [1e-13, 1e-13, 1e-12]),
  beside("stiction_single", [1e-4, null, 1e-3], { build_of: "stiction" }),
  beside("swift", [1e-5, 1e-6, 1e-7]),
];

test("another build stands beside its engine, effort by effort", () => {
  const [table, ...more] = builds_beside(precisions());
  assert.deepEqual(more, []);
  assert.deepEqual([table.own, table.build], ["stiction · quiet", "stiction_single · quiet"]);
  assert.deepEqual(
    table.answers.map(({ effort, own, build, speed }) => [effort, own.error, build.error, speed]),
    [
      [0, 1e-13, 1e-4, 1],
      [1, 1e-13, null, null],
      [2, 1e-12, 1e-3, 1],
    ],
  );
  assert.equal(table.answers[1].build.kind, "broke");
  assert.deepEqual(builds_beside(precisions().slice(0, 1)), []);
});

test("another build of ours is neither ours nor another's, and drawn in ink, dotted", () => {
  const [own, build, other] = precisions();
  const [loose] = cheapest_ways(points_of([own, build]));
  assert.equal(loose.theirs, null);
  assert.equal(cheapest_ways(points_of([build, other]))[0].theirs.name, "swift · quiet");
  const entries = precisions().map(({ name, record: one }) => ({
    record: one,
    variant: { rule: one.engine, name },
  }));
  const plot = engine_work_plot(entries);
  const [, { data, encoding }] = plot.spec.layer;
  assert.deepEqual(
    [...new Set(data.values.map(({ who, ours, build: dotted }) => `${who} ${ours} ${dotted}`))],
    ["stiction · quiet true false", "stiction_single · quiet true true", "swift · quiet false false"],
  );
  assert.deepEqual(encoding.color.scale.range.slice(0, 2), ["$ink", "$ink"]);
  assert.match(plot.caption, /Dotted: another build of the same engine/);
});

test("a point keeps its effort where the one before failed", () => {
  const curve = record({
    case: "engines/a",
    settings: { configuration: "default" },
    failures: [{ reason: "it hung", parameter: "effort", values: [0] }],
    series: [{ name: "error", unit: "1", x: [1, 2], y: [1e-2, 1e-3] }],
  });
  const [variant] = compared_variants([curve]);
  const { spec } = engine_work_plot([{ record: curve, variant }]);
  assert.deepEqual(
    spec.layer[1].data.values.map(({ effort }) => effort),
    [1, 2],
  );
});

test("the index has rows and columns in the order of the records, and nothing judged", () => {
  const { index } = data_of(all);
  const { rows, questions, judged, findings, cheapest } = index.engines;
  assert.deepEqual(
    rows.map(({ name }) => name),
    ROWS.map(row_name),
  );
  assert.deepEqual(
    questions.map(({ id }) => id),
    QUESTIONS.map(({ id }) => id),
  );
  assert.equal(questions[1].words, "Does it hold in scene 0? Falling to 1°");
  assert.deepEqual(
    questions.slice(0, 3).map(({ unit }) => unit),
    ["m/s", "°", "relative"],
  );
  assert.equal(index.engines.priced, "question-0");
  assert.equal(rows[0].seconds, 1e-4);
  assert.equal(cheapest.length, QUESTIONS.filter(({ curve }) => curve).length);
  assert.equal(index.compared, null);
  assert.equal(index.summary, null);
  assert.deepEqual(findings[0].notes, ENGINE_FINDINGS);
  assert.equal(
    Object.values(judged.counts).reduce((a, b) => a + b, 0),
    all.filter(is_answer).length,
  );
});

test("two runs are told apart; what else a page holds is judged as ever", () => {
  const twice = data_of(all, all).index.engines;
  assert.equal(twice.rows.length, 2 * ROWS.length);
  assert.equal(new Set(twice.rows.map(({ name }) => name)).size, 2 * ROWS.length);
  const mixed = data_of(all, [record(), record({ case: "incline/stop/mu=0.5" })]).index;
  assert.ok(mixed.summary);
  assert.equal(mixed.engines.rows.length, ROWS.length);
  assert.equal(mixed.check_counts.pass, 2);
  assert.equal(data_of([record()]).index.engines, null);
});
