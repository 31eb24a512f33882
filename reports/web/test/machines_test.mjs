// SPDX-License-Identifier: GPL-3.0-or-later
// Timings of different machines are never shown as if they were of one.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { cheapest_by_machine } from "../model/cheapest_way.js";
import { compare } from "../model/compare.js";
import { know_machines, machines_of, timings_sentence } from "../model/machine.js";
import { comparison_plots } from "../plots/comparison_plot.js";
import { case_plots, comparison_scores, family_plots } from "../plots/plots.js";
import { work_precision_plot } from "../plots/work_precision_plot.js";
import { figure } from "./compared_records.mjs";
import { record } from "./records.mjs";
import { MACHINES, on } from "./sweep_records.mjs";

const TOLD =
  /Timings of 2 machines, which don't compare: A: Example CPU, 2 cores; B: Other CPU, 64 cores\./;
const RUNS = [
  { role: "shown", short: "one", date: "1" },
  { role: "shown", short: "two", date: "2" },
];
const entries_of = (records) => records.map((one) => ({ record: one, run: 0 }));
const values_of = (spec) => [spec, ...(spec.layer ?? [])].flatMap(({ data }) => data?.values ?? []);

beforeEach(() => know_machines([]));

test("machines are told apart by name and toolchain, and called by letters", () => {
  const [a, b] = machines_of([record(on("a")), record(on("b")), record(on("a"))]);
  assert.deepEqual([a.letter, a.name, a.records.length], ["A", "Example CPU, 2 cores", 2]);
  assert.deepEqual([b.letter, b.name], ["B", "Other CPU, 64 cores"]);
  assert.equal(timings_sentence([record(on("a")), record(on("a"))]), "");
  const newer = record({
    environment: { ...record().environment, ...MACHINES.a, toolchain: "GCC 13" },
  });
  assert.match(
    timings_sentence([record(on("a")), newer]),
    /A: Example CPU, 2 cores, GCC 12.2.0, Release; C: .*, GCC 13\./,
  );
  const elsewhere = record({
    environment: { ...record().environment, ...MACHINES.a, host: "node-9" },
  });
  assert.equal(
    timings_sentence([record(on("a")), elsewhere]),
    "",
    "hosts alike have timings alike",
  );
});

const timed = (name, configuration, machine, seconds) =>
  record({
    case: name,
    configuration,
    ...on(machine),
    cost: { ...record().cost, cpu_seconds: seconds },
  });

test("work and precision has a series a machine, and sums none over two", () => {
  const records = ["x/1", "x/2"].flatMap((name) => [
    timed(name, "quiet", "a", 1),
    timed(name, "quiet", "b", 3),
    timed(name, "old", "a", 2),
  ]);
  const plot = work_precision_plot(records);
  assert.match(plot.caption, TOLD);
  const names = new Set(
    values_of(plot.spec)
      .map(({ configuration }) => configuration)
      .filter(Boolean),
  );
  assert.deepEqual([...names].sort(), ["old · A", "quiet · A", "quiet · B"]);
  const sums = values_of(plot.spec).filter((one) => one.check === "worst of these");
  assert.deepEqual(sums.map(({ seconds }) => seconds).sort(), [2, 4, 6]);
  assert.doesNotMatch(
    work_precision_plot(
      records
        .filter(({ configuration }) => configuration === "old")
        .concat(timed("x/1", "quiet", "a", 9)),
    ).caption,
    /Timings/,
  );
});

test("a history of CPU time is broken where the machine changes", () => {
  const entries = [0, 1].map((run) => ({ run, record: timed("x/1", "quiet", "ab"[run], 1) }));
  const [seconds] = family_plots("x", entries, RUNS).filter(({ title }) =>
    title.startsWith("CPU time"),
  );
  assert.match(seconds.caption, TOLD);
  assert.deepEqual(
    values_of(seconds.spec).map(({ machine }) => machine),
    ["A", "B"],
  );
  assert.equal(seconds.spec.encoding.color.field, "machine_key");
  const digits = family_plots("x", entries, RUNS).find(({ title }) =>
    title.startsWith("Fewest digits"),
  );
  assert.doesNotMatch(digits.caption, /Timings/);
});

const scaling = (machine, name = "contact phases", x_name = "contacts") => ({
  series: [{ name, unit: "s", x_name, x_unit: "1", x: [10, 100, 1000], y: [1, 10, 100] }],
  ...on(machine),
});

test("scaling, histories and times by phase name their machines", () => {
  const records = [
    record({ ...scaling("a"), configuration: "quiet" }),
    record({ ...scaling("b"), configuration: "old" }),
  ];
  const plots = case_plots("x/1", entries_of(records), RUNS);
  assert.deepEqual(
    plots.map(({ kind }) => kind),
    ["scaling", "phases"],
  );
  for (const plot of plots) {
    assert.match(plot.caption, TOLD);
    assert.ok(
      values_of(plot.spec).some(({ variant }) => variant === "quiet · A"),
      plot.kind,
    );
  }
  const history = ["a", "b"].map((machine) =>
    record({ ...scaling(machine, "time", "run"), cost: { ...record().cost, phase_seconds: {} } }),
  );
  assert.match(case_plots("trend/x", entries_of(history), RUNS)[0].caption, TOLD);
  const [alone] = family_plots("trend/x", entries_of(history), RUNS).filter(
    ({ title }) => title === "time over run",
  );
  assert.match(alone.caption, TOLD);
});

test("what is no timing is one series whatever the machine", () => {
  const records = ["a", "b"].map((machine) =>
    record({
      ...scaling(machine, "distance error", "time step"),
      settings: { of: machine },
      cost: { ...record().cost, phase_seconds: {} },
    }),
  );
  const [plot] = case_plots("x/1", entries_of(records), RUNS);
  assert.doesNotMatch(plot.caption, /Timings/);
});

const compared = (rule, machine, i, seconds) =>
  record({
    case: `rules/work/mesh=${i}`,
    settings: { method: "quiet", rule },
    checks: [],
    figures: [figure("CPU time", "s", seconds), figure("final creep", "m/s", 10 ** -i)],
    ...on(machine),
  });

test("rules are told apart by machine, and none is the front of another's", () => {
  const records = [1, 2].flatMap((i) => [
    compared("secant", "a", i, i),
    compared("none", "b", i, 10 * i),
  ]);
  const [plot] = family_plots("rules/work", entries_of(records), RUNS);
  assert.match(plot.caption, TOLD);
  assert.match(plot.caption, /front/);
  const stepped = plot.spec.layer.find(({ mark }) => mark.interpolate === "step-after");
  assert.deepEqual(new Set(stepped.data.values.map(({ machine }) => machine)), new Set(["A", "B"]));
  assert.equal(stepped.encoding.detail.field, "machine");
});

test("scores of CPU time name the machines, other scores don't", () => {
  const records = ["secant", "none", "fixed-point"].flatMap((rule, k) =>
    ["u", "v", "w"].map((scene, i) => ({
      ...compared(rule, k === 0 ? "a" : "b", i, 10 ** k),
      case: `rules/${scene}`,
    })),
  );
  const [{ plots }] = comparison_scores(entries_of(records), RUNS);
  const [cost, creep] = ["CPU time", "final creep"].map((name) =>
    plots.find(({ quantity }) => quantity === name),
  );
  assert.match(cost.caption, TOLD);
  assert.ok(values_of(cost.spec).some(({ rule }) => rule.endsWith(" · A")));
  assert.doesNotMatch(creep?.caption ?? "", /Timings/);
});

const asked = (engine, machine, seconds) =>
  record({
    case: "engines/slope",
    engine,
    ...on(machine),
    checks: [],
    verdict: "for-information",
    figures: [figure("error", "1", 1e-3), figure("CPU time", "s", seconds)],
    series: [
      {
        name: "error",
        unit: "1",
        x_name: "CPU time",
        x_unit: "s",
        x: [seconds, 2 * seconds],
        y: [1e-3, 1e-5],
      },
    ],
  });

test("engines on several machines have a front each, and no ratio between them", () => {
  const records = [asked("stiction", "a", 2), asked("ode", "a", 1), asked("dart", "b", 0.1)];
  const [plot] = family_plots("engines/slope", entries_of(records), RUNS);
  assert.match(plot.caption, TOLD);
  const front = plot.spec.layer[0];
  assert.deepEqual(new Set(front.data.values.map(({ machine }) => machine)), new Set(["A", "B"]));
  assert.equal(front.encoding.detail.field, "machine");
  const ways = cheapest_by_machine(records.map((one) => ({ name: one.engine, record: one })));
  assert.deepEqual(
    ways.map(({ machine }) => machine),
    ["A", "B"],
  );
  assert.equal(ways[0].ways[0].theirs.name, "ode");
  assert.equal(ways[1].ways[0].ours, null);
});

test("two runs are compared in time among pairs of the same two machines", () => {
  const pairs = Array.from({ length: 20 }, (_, i) => `x/${i}`);
  const before = pairs.map((name) => timed(name, "quiet", "a", 1));
  const after = pairs.map((name, i) => timed(name, "quiet", i < 10 ? "a" : "b", i < 10 ? 1 : 0.3));
  const changes = compare(before, after);
  assert.ok(
    changes.every(({ class: name }) => name === "same"),
    "a faster machine is no faster program",
  );
  assert.equal(changes.filter(({ across }) => across).length, 10);
  const few = compare(before.slice(0, 2), [after[0], timed("x/1", "quiet", "b", 0.3)]);
  assert.ok(
    few.every(({ class: name }) => name === "same"),
    "nor are few pairs",
  );
  const slower = compare(before.slice(0, 2), [after[0], timed("x/1", "quiet", "a", 3)]);
  assert.deepEqual(
    slower.map(({ class: name }) => name),
    ["slower", "same"],
  );
  const [plot] = comparison_plots(changes.map((one) => ({ ...one, family: "x" })));
  assert.match(plot.caption, /another machine/);
  assert.equal(plot.spec.layer[1].encoding.color.field, "across");
});
