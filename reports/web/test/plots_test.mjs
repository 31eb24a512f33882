// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of which series, and how.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { rules_on_contacts } from "../model/rule.js";
import { signed_axis } from "../plots/axes.js";
import { pareto_front, power_law } from "../plots/fit.js";
import { late_tips } from "../plots/late_tips.js";
import { tip, tip_number } from "../plots/names.js";
import { kind_of } from "../plots/parameter_plot.js";
import { case_plots, family_plots } from "../plots/plots.js";
import { bracket_in } from "../plots/threshold_plot.js";
import { record } from "./records.mjs";

const SCHEMA = new URL("../../record/schema.json", import.meta.url);
const schema = JSON.parse(readFileSync(SCHEMA, "utf8"));

test("a power law is fitted", () => {
  const fit = power_law([1, 2, 4, 8].map((x) => ({ x, y: 3 * x ** 2 })));
  assert.ok(Math.abs(fit.exponent - 2) < 1e-12 && Math.abs(fit.factor - 3) < 1e-12);
  assert.equal(
    power_law([
      { x: 1, y: 1 },
      { x: 1, y: 2 },
    ]),
    null,
  );
  assert.equal(
    power_law([
      { x: 1, y: 0 },
      { x: 2, y: 2 },
    ]),
    null,
  );
});

test("the Pareto front leaves out what another beats", () => {
  const points = [
    { c: 1, e: 5 },
    { c: 2, e: 5 },
    { c: 3, e: 1 },
    { c: 4, e: 2 },
    { c: 1, e: 6 },
  ];
  assert.deepEqual(
    pareto_front(
      points,
      ({ c }) => c,
      ({ e }) => e,
    ),
    [
      { c: 1, e: 5 },
      { c: 3, e: 1 },
    ],
  );
});

test("series over a parameter are told apart", () => {
  assert.equal(kind_of({ name: "distance error", unit: "m", x_name: "time step" }), "convergence");
  assert.equal(kind_of({ name: "contact phases", unit: "s", x_name: "contacts" }), "scaling");
  assert.equal(
    kind_of({ name: "start-up slip", unit: "m", x_name: "Young's modulus" }),
    "dependence",
  );
});

test("brackets are read from notes, however the case tells them", () => {
  const of = (note) => Object.values(bracket_in(note) ?? {});
  assert.deepEqual(
    of("bracket on tan θ: holds at 0.4999, slides at 5.001e-1; 28 runs"),
    [0.4999, 0.5001],
  );
  assert.deepEqual(
    of("holds at N = 9.8129 N, fails at 9.8100 N, 12 runs; Δh/w = 0.1"),
    [9.8129, 9.81],
  );
  assert.deepEqual(of("stands at tan θ = 0.29550, slides at 0.29600, 9 runs"), [0.2955, 0.296]);
  assert.deepEqual(of("the box holds, and slides later"), []);
});

test("a series over runs is drawn as history, without a fitted power law", () => {
  const over = (x_name) => ({
    ...{ name: "time", unit: "ns", x_name, x_unit: "1" },
    ...{ x: [1, 2, 3], y: [8, 4, 2] },
  });
  const kinds = (series) =>
    case_plots("trend/step", [{ record: { ...record(), series }, run: 0 }], [{ short: "" }]).map(
      ({ kind }) => kind,
    );
  assert.deepEqual(kinds([over("run")]), ["trend", "phases"]);
  assert.ok(!kinds([over("cells")]).includes("trend"));
});

test("the time by phase is named as records define it", () => {
  const [plot] = case_plots("incline/stop", [{ record: record(), run: 0 }], [{ short: "" }]).filter(
    ({ kind }) => kind === "phases",
  );
  const { description } = schema.definitions.cost.properties.phase_seconds;
  assert.equal(plot.title.toLowerCase(), description.split(",")[0]);
  assert.doesNotMatch(JSON.stringify(plot), /CPU/);
});

test("times and digits over runs stand on their family's page, each in one picture", () => {
  const over_runs = (name) => ({
    ...{ name, unit: "1", x_name: "run", x_unit: "1" },
    ...{ x: [1, 2], y: [8, 4] },
  });
  const entry = (name, series) => ({ record: { ...record(), case: name, series }, run: 0 });
  const plots = family_plots(
    "trend/slab",
    [
      entry("trend/slab/a", [
        over_runs("time"),
        over_runs("allocations"),
        over_runs("digits: creep"),
      ]),
      entry("trend/slab/b", [over_runs("digits: creep"), over_runs("digits: energy")]),
    ],
    [{ short: "", role: "shown", date: "" }],
  ).filter(({ kind }) => kind === "trend");
  assert.deepEqual(
    plots.map(({ title }) => title),
    ["time over run", "digits over run"],
  );
  assert.match(plots[1].description, /3 curves/);
});

test("contacts are told apart by their depth rule where it differs", () => {
  const one = (name, method, depth) =>
    record({ case: name, settings: { method, depth, rule: "secant" } });
  const contacts = (records) => rules_on_contacts(records).map((variant) => variant.contacts);
  assert.deepEqual(
    contacts([
      one("a", "paper", "projection"),
      one("a", "paper", "consistent"),
      one("a", "quiet", "projection"),
      one("b", "paper", "projection"),
    ]),
    ["paper, projection depth", "paper, consistent depth", "quiet", "paper"],
  );
});

test("an axis of both signs is logarithmic where its values span decades", () => {
  const axis = (values) => signed_axis("x", "α", "s/m", values, { domain: [-1000, 1000] });
  const wide = axis([-1000, -0.01, 0, 0.01, 1000]);
  assert.equal(wide.scale.type, "symlog");
  assert.equal(wide.scale.constant, 0.01);
  assert.deepEqual(wide.axis.values, [-1000, -10, -0.1, 0, 0.1, 10, 1000]);
  assert.equal(axis([-0.5, 0, 2.5]).scale.type, "linear");
});

test("a mark tells its own values, wherever its list of tooltips stands", () => {
  const unit = (...tooltip) => ({ mark: "point", encoding: { x: { field: "x" }, tooltip } });
  const spec = {
    facet: { field: "f" },
    spec: { layer: [unit(tip("who", "engine")), { mark: "line", encoding: {} }] },
    concat: [unit(tip_number("x", "μ"), tip("why", "__proto__"))],
  };
  const { spec: late, tip_of } = late_tips(spec, (value) => value.toFixed(2));
  const places = [late.concat[0], late.spec.layer[0]].map(({ encoding }) => encoding.tooltip.value);
  const datum = { who: "ode", x: 0.3, why: undefined };
  assert.deepEqual(tip_of(places[0], datum), { "μ:": "0.30", "__proto__:": "undefined" });
  assert.deepEqual(tip_of(places[1], datum), { "engine:": "ode" });
  assert.deepEqual(late.spec.layer[1], spec.spec.layer[1]);
  assert.deepEqual(late.concat[0].encoding.x, { field: "x" });
  assert.equal(spec.concat[0].encoding.tooltip.length, 2, "the specification itself stays");
});
