// SPDX-License-Identifier: GPL-3.0-or-later
// How far a ladder holds, which perturbation a check tells of, and the commands that rerun a point.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { holds, ratio_of, rung_of, span_of } from "../model/ladder.js";
import {
  groups_of,
  lacking_of,
  PERTURBATION_NAMES,
  perturbation_of,
} from "../model/perturbation.js";
import { exact_command, perturbed_command } from "../model/rerun.js";
import { stability_counts, stability_of } from "../make/stability.mjs";
import { digits_text } from "../page/views/digits_table.js";
import { parameter_places, ratio_places } from "../plots/ladder_axes.js";
import { ladder_plots } from "../plots/ladder_plot.js";
import { record } from "./records.mjs";
import { perturbed, rung, stability_records, survived } from "./stability_records.mjs";

// "1+ 10+ 100-": rungs that hold, fail and (?) decide nothing.
const rungs = (text) =>
  text.split(" ").map((word) => ({
    value: Number(word.slice(0, -1)),
    holds: { "+": true, "-": false, "?": null }[word.at(-1)],
  }));
const span = (text) => {
  const { lowest, highest, below, above, beyond } = span_of(rungs(text));
  return [below, lowest, highest, above].map((end) => end?.value ?? null).concat(beyond);
};

test("a ladder holds without a break around the rung nearest to 1", () => {
  const expected = {
    "1+ 10+ 100+": [null, 1, 100, null, 0],
    "100- 1+ 10+": [null, 1, 10, 100, 0], // in any order
    "1e-6- 0.01+ 1+ 10+ 100- 1000+": [1e-6, 0.01, 10, 100, 1],
    "2+ 5+ 20- 40+": [null, 2, 5, 20, 1],
    "0+ 1e-6- 0.1+": [1e-6, 0.1, 0.1, null, 1], // zero is farther than any positive number
    "-1e-12- -1e-15+ 0+ 1e-9+": [-1e-12, -1e-15, 1e-9, null, 0],
    "-1- 0+": [-1, 0, 0, null, 0],
    "0.1+ 0.2+ 0.4-": [null, 0.1, 0.2, 0.4, 0], // the nearest fails: the nearest that holds
    "1- 10-": [null, null, null, 1, 0],
    "1+ 10? 100+ 1000-": [null, 1, 100, 1000, 0],
    "1?": [null, null, null, null, 0],
  };
  for (const [text, ends] of Object.entries(expected)) assert.deepEqual(span(text), ends, text);
});

test("a rung for information holds where each of its checks is within its tolerance", () => {
  const verdict = "for-information";
  for (const [ratio, expected] of [[0.5, true], [1, true], [7, false], ["inf", false]])
    assert.equal(holds(rung("mass/top=10", ratio, { verdict })), expected, String(ratio));
  const one = rung("mass/top=10", 7, { verdict });
  for (const check of one.checks) check.verdict = verdict;
  assert.equal(ratio_of(one), 7, "the farthest decides");
});

test("a rung is read from its case's name", () => {
  const { ladder, parameter, value } = rung_of("ladder/mass-ratio/top=1e+06");
  assert.deepEqual([ladder, parameter, value], ["mass-ratio", "top", 1e6]);
  assert.equal(rung_of("ladder/a/b/gap=-1e-12").ladder, "a/b");
  for (const name of ["ladder/x/y=z", "ladder/x/y=", "ladder/x", "slab/x=1", "ladder/x/y=inf"])
    assert.equal(rung_of(name), null, name);
});

test("groups stand in the order of the records, where a record has one that others lack", () => {
  const of = (...names) =>
    perturbed(
      "a",
      names.map((name) => survived(name, 0)),
    );
  const lacks = { ...of("rerun", "ulp"), notes: ["single: not applicable: there is none"] };
  assert.deepEqual(groups_of([lacks, of("rerun", "turned", "moved", "ulp", "fused")]), [
    "rerun",
    "turned",
    "moved",
    "ulp",
    "fused",
    "single",
  ]);
  assert.deepEqual([...lacking_of(lacks)], [["single", "there is none"]]);
});

test("the worst figure tells its perturbation", () => {
  const expected = {
    "height: 1 m, not 1, when turned by 40° about (1, 2, 3)": "turned/2",
    "height: 1 m, not 1, when turned by -115° about (-2, 1, 0.5)": "turned/3",
    "speed: 1 m/s, not 1, when moved 1e+06 m away along (2, −3, 6)": "moved/1e+06",
    "moved 1 m away along (2, −3, 6): it exploded": "moved/1",
    "x: 1 1, not 2, when bodies and obstacles in another order, seed 2": "bodies/2",
    "each number of the scene ±1 ulp or 0 off, seed 10: it broke off": "ulp/10",
    "x: 1 1, not 2, when the engine's arithmetic rounds toward-zero": "rounding/toward-zero",
    "the engine's arithmetic rounds upward: it broke": "rounding/upward",
    "12 steps were not the same when taken again": "rewind",
    "x: 1 1, not 2, when lengths × 1e-3, masses × 1e3, times × 10": "units",
    "x: 1 1, not 2, when a·b + c rounded once": "fused",
    "": "",
    "nobody knows": "",
  };
  for (const [worst, name] of Object.entries(expected))
    assert.equal(perturbation_of({ worst }), name, worst);
});

test("the names are those that ./stiction validate --perturb knows", () => {
  const source = readFileSync(
    new URL("../../../validation/stability/perturbation.cpp", import.meta.url),
    "utf8",
  );
  for (const name of PERTURBATION_NAMES) {
    const start = name.replace(/(?<=\/).*/, "");
    assert.ok(source.includes(`"${start}`), name);
  }
  const turns = [...source.matchAll(/\{(-?[\d.]+), \{[^}]*\}\}/g)].map(([, degrees]) =>
    Number(degrees),
  );
  turns.forEach((degrees, i) =>
    assert.equal(perturbation_of({ worst: `turned by ${degrees}° about` }), `turned/${i + 1}`),
  );
  assert.equal(turns.length, 3);
});

test("a point is rerun by its perturbation, in its configuration, on its engine", () => {
  const one = perturbed("stack/rest/n=2", [], { engine: "it's", differs: { kappa: "0.7" } });
  assert.equal(
    perturbed_command(one, "turned/2"),
    `./stiction validate --case 'stack/rest/n=2' --engine 'it'\\''s' --perturb 'turned/2' --configuration 'quiet' --set 'kappa=0.7'`,
  );
  assert.equal(
    exact_command(record({ case: "ladder/a/b=1" })),
    "./stiction validate --case 'ladder/a/b=1'",
  );
  assert.match(
    exact_command({ ...one, differs: { finer: "2", kappa: "0.7" } }),
    /--configuration 'quiet' --finer '2' --set 'kappa=0.7'$/,
  );
});

test("digits are never rounded up", () => {
  assert.equal(digits_text({ value: 1.1e-10, digits: 9.956 }), "9.9");
  assert.equal(digits_text({ value: 1e-17, digits: 16 }), "16");
  assert.equal(digits_text({ value: 0, digits: 16 }), "exact");
  assert.equal(digits_text({ value: "inf", digits: 0 }), "–");
  assert.equal(digits_text({ value: 1, digits: null }), "–");
});

test("zero and what is negative stand left of a gap, in order", () => {
  const values = [1e-9, 0, -1e-15, 1e-15, -1e-12];
  const { place_of, gap } = parameter_places(values, String);
  const places = [...values].sort((a, b) => a - b).map(place_of);
  for (let i = 1; i < places.length; ++i) assert.ok(places[i] > places[i - 1]);
  assert.ok(place_of(0) < gap && gap < place_of(1e-15));
  assert.equal(parameter_places([1, 10], String).gap, null);
  assert.ok(parameter_places([5], String).domain.every(Number.isFinite));
  assert.ok(parameter_places([0], String).domain.every(Number.isFinite));
});

test("ratios: an exact zero at the floor, what has no end at the ceiling", () => {
  const { place_of, floor, ceiling, strip } = ratio_places([0, 1e-9, 30, Infinity]);
  const places = [0, 1e-9, 1, 30, Infinity].map(place_of);
  for (let i = 1; i < places.length; ++i) assert.ok(places[i] > places[i - 1]);
  assert.ok(floor < places[0] && places.at(-1) < ceiling && strip < places.at(-1));
  assert.equal(place_of(1), 0);
  assert.equal(ratio_places([0.5]).strip, null);
});

const name_of = ({ engine, configuration }) =>
  engine === "stiction" ? configuration : `${engine} · ${configuration}`;
const series_of = ({ record: one }) => name_of(one);
const entries = (records) => records.map((one) => ({ record: one, run: 0 }));

test("of each configuration a table, of each ladder what breaks it", () => {
  const told = stability_of(entries(stability_records()), name_of, series_of);
  assert.deepEqual(
    told.groups.map(({ name }) => name),
    ["rerun", "turned", "bodies renumbered", "other units"],
  );
  assert.deepEqual(
    told.tables.map(({ name }) => name),
    ["quiet", "paper, secant", "other · quick"],
  );
  const [fall, stack] = told.tables[0].rows;
  assert.match(fall.cells[2].lacking, /too few bodies/);
  assert.match(stack.cells[1].command, /--case 'stack\/rest\/n=2' --perturb 'turned\/2'/);
  assert.match(stack.cells[3].command, /--case 'perturbed\/stack\/rest\/n=2' --configuration/);
  assert.equal(told.tables[2].rows[1].ended, "it exploded");
  assert.deepEqual(
    told.ladders.map(({ key }) => key),
    ["mass-ratio/top", "touching/gap", "cone/load"],
  );
  const [quiet, secant, other] = told.ladders[0].rows;
  assert.deepEqual([quiet.highest.text, quiet.above.text, quiet.beyond], ["100", "1000", 1]);
  assert.equal(quiet.above.failure, "contact slip: 30 × its tolerance; box 3");
  assert.deepEqual([secant.highest.text, secant.above.text], ["10", "100"]);
  assert.equal(other.above.failure, "broke off: it exploded");
  assert.match(other.above.command, /--case 'ladder\/mass-ratio\/top=10000' --engine 'other'/);
  assert.deepEqual([told.ladders[1].rows[2].decided, told.ladders[1].rows[2].lacking], [0, 1]);
  assert.deepEqual(stability_counts(told), {
    configurations: 3,
    cases: 6,
    kept: 3,
    ladders: 6,
    whole: 1,
  });
  assert.equal(stability_of(entries([record()]), name_of, series_of), null);
});

test("a ladder is one plot of all configurations, with what breaks in words", () => {
  const plots = ladder_plots(entries(stability_records()), name_of, series_of);
  assert.deepEqual(
    plots.map(({ ladder }) => ladder),
    ["mass-ratio/top", "touching/gap", "cone/load"],
  );
  assert.match(plots[0].description, /quiet holds|quiet: holds 1 … 100, breaks at 1000/);
  assert.match(plots[1].caption, /1 rung not applicable/);
  assert.match(plots[2].caption, /Holds on every rung/);
  assert.deepEqual(ladder_plots(entries([record()]), name_of, series_of), []);
});
