// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of a sweep's points.
import assert from "node:assert/strict";
import { test } from "node:test";
import { know_machines } from "../model/machine.js";
import { case_command, record_command } from "../model/rerun.js";
import { varying_axes } from "../model/sweep.js";
import { work_points } from "../model/work.js";
import { luminance_steps } from "../plots/colour_scale.js";
import { family_plots } from "../plots/plots.js";
import { check, record } from "./records.mjs";
import { grid, measured, on, point, scattered, steps } from "./sweep_records.mjs";

const RUNS = [
  { role: "shown", short: "now" },
  { role: "shown", short: "then" },
];
const plots_of = (records, kind = "phase-diagram") =>
  family_plots(
    "user/box",
    records.map((one) => (one.record ? one : { record: one, run: 0 })),
    RUNS,
  ).filter((plot) => plot.kind === kind);
const layers_of = (spec) => spec.layer ?? [spec];
const coloured = ({ spec }) =>
  layers_of(spec.spec ?? spec).find(({ encoding }) => encoding.color?.type === "quantitative");
const rows = ({ spec }) => spec.data.values;

test("a sweep over two axes is a diagram of verdicts, one a configuration", () => {
  const points = [];
  for (const configuration of ["quiet", "paper"])
    for (const mu of [0.1, 1, 10])
      for (const slope_deg of [10, 20])
        points.push(
          point(
            { mu, slope_deg },
            { configuration, verdict: mu > slope_deg / 30 ? "pass" : "fail" },
          ),
        );
  const plots = plots_of(points);
  assert.equal(plots.length, 2);
  const { spec, caption } = plots[0];
  assert.equal(spec.data.values.length, 6);
  assert.equal(spec.encoding.x.scale.type, "log", "spaced by factors");
  assert.equal(spec.encoding.y.scale.type, "linear");
  assert.match(spec.encoding.y.axis.title, /slope_deg \(°\)/);
  assert.deepEqual(spec.encoding.color.legend.values, ["fail", "pass"]);
  assert.equal(caption, "2 fail, 4 hold.");
  assert.match(spec.data.values[0].case, /^user\/box\/mu=/, "a click opens the point's case");
});

test("a sweep over one axis is a curve of each check", () => {
  const line = [1, 2, 3].map((mass) => point({ mass, mu: 0.5 }, { configuration: "quiet" }));
  const [plot, ...more] = plots_of(line);
  assert.equal(more.length, 0);
  assert.equal(plot.title, "stopping distance over mass");
  assert.deepEqual(
    plot.spec.data.values.map(({ x }) => x),
    [1, 2, 3],
  );
});

test("an axis is logarithmic where its values are spaced by factors, however far they reach", () => {
  const log_of = (values) => varying_axes(values.map((mu) => point({ mu })))[0].log;
  const evenly = Array.from({ length: 50 }, (_, i) => 0.01 + 0.02 * i);
  assert.equal(log_of(evenly), false);
  assert.equal(log_of([2.5e-5, 5e-5, 1e-4, 2e-4]), true);
  assert.equal(log_of([0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1]), true);
  assert.equal(log_of([1, 100]), false);
  assert.equal(log_of([-1, 0, 1, 100]), false);
});

test("points of a sweep are none of the points of precision over cost", () => {
  const never = point({ mu: 1 }, { checks: [check({ value: "inf", error: "inf" })] });
  assert.deepEqual(work_points([never]), []);
  assert.equal(work_points([record()]).length, 1);
});

test("a point of a sweep is run again by its name", () => {
  const one = point({ mu: 1 }, { configuration: "quiet" });
  assert.equal(case_command(one), `./stiction sweep STUDY.toml --point '${one.point}'`);
  assert.equal(record_command(one), case_command(one));
  assert.equal(
    case_command(record({ case: "sweep/ramp/boundary" })),
    "./stiction sweep STUDY.toml",
  );
});

test("records of no sweep have no such diagram", () => assert.deepEqual(plots_of([record()]), []));

const CUBE = { mu: steps(0.1, 0.9, 5), slope_deg: steps(3, 45, 4), mass: [1, 2, 4] };

test("three axes are a row of small diagrams, one a value of the axis with fewest", () => {
  const [plot, ...more] = plots_of(grid(CUBE).map((axes) => point(axes)));
  assert.equal(more.length, 0);
  assert.equal(plot.spec.facet.field, "facet_key");
  assert.match(plot.spec.facet.header.labelExpr, /mass = 1.*mass = 2.*mass = 4/);
  assert.match(plot.title, /over mu and slope_deg, by mass/);
  assert.match(plot.spec.spec.encoding.x.axis.title, /mu/);
  assert.equal(rows(plot).length, 60);
  assert.equal(plot.spec.usermeta.panels, 3);
});

test("scattered points of three axes, four axes, and many values are every pair of axes", () => {
  const cases = [
    [scattered({ mu: [0.1, 1], slope_deg: [3, 45], mass: [1, 4] }, 40), 3],
    [grid({ ...CUBE, size: [1, 2] }), 6],
    [grid({ mu: steps(0, 1, 13), slope_deg: steps(3, 45, 13), mass: steps(1, 2, 13) }), 3],
  ];
  for (const [points, pairs] of cases) {
    const [plot] = plots_of(points.map((axes) => point(axes)));
    assert.equal(plot.spec.concat.length, pairs);
    assert.equal(plot.spec.usermeta.panels, pairs);
    const axes = new Set(
      plot.spec.concat.map(({ encoding }) => encoding.x.axis.title + encoding.y.axis.title),
    );
    assert.equal(axes.size, pairs);
  }
});

test("where two axes vary each check has a map, coloured by its value", () => {
  const points = grid({ "ramp.friction": steps(0.1, 0.9, 5), "ramp.slope_deg": steps(3, 45, 5) });
  const maps = plots_of(
    points.map((axes) => measured(axes)),
    "heat-map",
  );
  assert.deepEqual(
    maps.map(({ title }) => title),
    [
      "mean velocity downhill over ramp.friction and ramp.slope_deg",
      "normal force over ramp.friction and ramp.slope_deg",
    ],
  );
  const velocity = coloured(maps[0]);
  assert.equal(velocity.mark.type, "rect", "a rectangle a point of the grid");
  assert.equal(velocity.encoding.color.scale.type, "log", "its values span decades");
  assert.match(velocity.encoding.color.legend.title, /mean velocity downhill \(m\/s\)/);
  assert.match(maps[0].caption, /tolerance 1e-06 m\/s/);
  assert.equal(coloured(maps[1]).encoding.color.scale.type, "linear");
});

test("scattered points are dots of the value's colour", () => {
  const points = scattered({ "ramp.friction": [0.1, 0.9], "ramp.slope_deg": [3, 45] }, 30);
  const [map] = plots_of(
    points.map((axes) => measured(axes)),
    "heat-map",
  );
  assert.notEqual(coloured(map).mark.type, "rect");
});

test("what broke off or is no number is marked, and has no colour of a value", () => {
  const points = grid({
    "ramp.friction": [0.1, 0.5],
    "ramp.slope_deg": [10, 45],
    "engine.dt": [1e-4, 1e-2],
  });
  const [map] = plots_of(
    points.map((axes) => measured(axes)),
    "heat-map",
  );
  const told = rows(map);
  assert.equal(told.filter(({ value }) => value === null).length, 5);
  assert.equal(told.filter(({ missing }) => missing === "broke off").length, 4);
  assert.equal(told.filter(({ missing }) => missing === "no finite number").length, 1);
  assert.match(map.caption, /4 broke off/);
  const layers = layers_of(map.spec.spec);
  const is_of_measured = ({ transform }) => JSON.stringify(transform ?? "").includes("value");
  assert.ok(layers.every(is_of_measured), "no layer draws both");
});

test("a point whose place is no number is told, and not drawn", () => {
  const points = grid({ a: [1, 2], b: [1, 2], c: [1, 2] }).map((axes) => point(axes));
  for (const name of ["a", "c"]) {
    const lost = point({ a: 1, b: 1, c: 1, [name]: "nan" });
    for (const kind of ["phase-diagram", "heat-map"]) {
      const [plot] = plots_of([...points, lost], kind);
      assert.equal(rows(plot).length, points.length, `${kind}, ${name}`);
    }
    assert.match(plots_of([...points, lost])[0].caption, /9 hold/);
  }
});

test("values of both signs over decades are coloured by their size", () => {
  const points = grid({ a: [1, 2, 3], b: [1, 2, 3] }).map((axes) =>
    measured(axes, {
      change: {
        checks: [{ ...record().checks[0], value: (axes.a - 2) * 10 ** (-3 * axes.b) }],
        verdict: "pass",
      },
    }),
  );
  const [map] = plots_of(points, "heat-map");
  assert.equal(coloured(map).encoding.color.scale.type, "log");
  assert.match(coloured(map).encoding.color.legend.title, /\|stopping distance\|/);
  assert.match(map.caption, /whatever its sign/);
});

test("configurations share the scale of a quantity", () => {
  const points = grid({ a: [1, 2], b: [1, 2] }).flatMap((axes) =>
    ["quiet", "old"].map((configuration, i) =>
      measured(axes, {
        change: {
          configuration,
          verdict: "pass",
          checks: [{ ...record().checks[0], value: axes.a + 10 * i }],
        },
      }),
    ),
  );
  const maps = plots_of(points, "heat-map");
  assert.equal(maps.length, 2);
  assert.deepEqual(...maps.map((map) => coloured(map).encoding.color.scale.domain));
  assert.match(maps[0].title, /^quiet: /);
});

test("CPU time has a map of its own, a map a machine where there are several", () => {
  const points = grid({ "ramp.friction": steps(0.1, 0.9, 5), "ramp.slope_deg": steps(3, 45, 5) });
  const [alone, ...more] = plots_of(
    points.map((axes) => measured(axes)),
    "sweep-cost",
  );
  assert.equal(more.length, 0);
  assert.match(alone.title, /^CPU time over/);
  const both = plots_of(
    points.map((axes, i) => measured(axes, { machine: i % 2 ? "a" : "b" })),
    "sweep-cost",
  );
  assert.equal(both.length, 2);
  assert.deepEqual(both.map((plot) => rows(plot).length).sort(), [12, 13]);
  for (const plot of both) assert.match(plot.caption, /Example CPU|Other CPU/);
});

test("CPU time over one axis is a curve a machine", () => {
  know_machines([]);
  const line = steps(1, 5, 5).map((mass) => point({ mass }, on(mass < 3 ? "a" : "b")));
  const [plot, ...more] = plots_of(line, "sweep-cost");
  assert.equal(more.length, 0);
  const keys = new Set(rows(plot).map(({ curve_key }) => curve_key));
  assert.equal(keys.size, 2);
  assert.match(plot.caption, /[Tt]imings of 2 machines.*A: Example CPU.*B: Other CPU/);
});

test("points that two runs have are drawn run by run", () => {
  const points = grid({ a: [1, 2], b: [1, 2] }).map((axes) => point(axes));
  const entries = [0, 1].flatMap((run) => points.map((one) => ({ record: one, run })));
  assert.equal(plots_of(entries).length, 1, "without what tells them apart the last counts");
  const plots = family_plots("user/box", entries, RUNS, {
    series_of: ({ run }) => RUNS[run].short,
  }).filter(({ kind }) => kind === "phase-diagram");
  assert.deepEqual(
    plots.map(({ title }) => title.split(":")[0]),
    ["now", "then"],
  );
});

test("very many points are thinned evenly, and the caption says so", () => {
  const points = grid({ a: steps(1, 2, 200), b: steps(1, 2, 150) }).map((axes) => point(axes));
  const [plot] = plots_of(points);
  assert.ok(rows(plot).length <= 20_000);
  assert.match(plot.caption, /30,000 hold.*every 2nd point is drawn/);
  assert.equal(rows(plot).at(-1).x, 2, "to the end of the axis");
});

test("the colours of values grow evenly lighter or darker in both themes", () => {
  for (const theme of ["light", "dark"]) {
    const changes = luminance_steps(theme);
    assert.ok(
      changes.every((step) => step > 0),
      `${theme}: ${changes}`,
    );
    assert.ok(Math.max(...changes) < 2.2 * Math.min(...changes), `${theme}: ${changes}`);
  }
});
