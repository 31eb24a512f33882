// SPDX-License-Identifier: GPL-3.0-or-later
// What configurations are called, and that each looks the same wherever it stands.
import assert from "node:assert/strict";
import { test } from "node:test";
import { configuration_of, ordered_configurations } from "../model/configuration.js";
import {
  configuration_styles,
  know_configurations,
  know_engines,
  variant_styles,
} from "../plots/configuration_style.js";
import { told_apart } from "../plots/variant_channels.js";
import { looks_of } from "../plots/engine_work_points.js";
import { record } from "./records.mjs";

test("a configuration's name is the record's, or read from an older record's settings", () => {
  const of = (settings, more) => configuration_of(record({ settings, ...more }));
  assert.equal(of({ method: "old" }, { configuration: "mine" }), "mine");
  assert.equal(of({ method: "quiet", rule: "conjugate-vector" }), "quiet");
  assert.equal(of({ method: "old", rule: "none" }), "old");
  assert.equal(of({ method: "paper", rule: "fixed-point", memory: "reset" }), "paper, fixed point");
  assert.equal(of({ method: "paper", rule: "secant" }), "paper, secant");
  assert.equal(of({ method: "paper", rule: "none" }), "paper, no memory");
  assert.equal(of({ rule: "conjugate-vector" }), "quiet");
  assert.equal(of({ rule: "fixed-point" }), "paper, fixed point");
  assert.equal(of({ configuration: "best" }, { engine: "bullet" }), "best");
  assert.equal(of({}, { engine: "bullet" }), "bullet");
  assert.equal(of({}), "quiet", "its own engine without settings");
});

test("this project's configurations come first, in their order", () => {
  assert.deepEqual(ordered_configurations(["a", "old", "quiet", "paper, secant", "quiet"]), [
    "quiet",
    "paper, secant",
    "old",
    "a",
  ]);
});

test("a configuration looks the same in whatever company", () => {
  const all = ["quiet", "paper, fixed point", "paper, secant", "paper, no memory", "old"];
  const colours = [...configuration_styles(all).values()].map(({ colour }) => colour);
  assert.deepEqual(colours, ["$s0", "$s1", "$s3", "$s4", "$s6"]);
  assert.deepEqual(configuration_styles(["old"]).get("old"), configuration_styles(all).get("old"));
  know_configurations(["b", "quiet", "a"]);
  const alone = configuration_styles(["b"]).get("b");
  assert.deepEqual(configuration_styles(["a", "b"]).get("b"), alone);
  assert.notDeepEqual(configuration_styles(["a"]).get("a"), alone);
  know_configurations([]);
});

test("variants of one configuration share its colour and differ in shape and dash", () => {
  const styles = variant_styles(["quiet", "old", "quiet", "quiet"]);
  assert.deepEqual(
    styles.map(({ colour }) => colour),
    ["$s0", "$s6", "$s0", "$s0"],
  );
  assert.equal(new Set(styles.map(({ shape }) => shape)).size, 4);
  assert.equal(new Set(styles.map(({ dash }) => JSON.stringify(dash))).size, 4);
});

test("an engine keeps its colour where others did not answer", () => {
  know_engines(["ode", "bullet", "dart"]);
  const colours = (...engines) =>
    looks_of(engines.map((rule) => ({ variant: { rule }, record: record() }))).map((one) => one.color);
  assert.equal(colours("ode")[0], colours("bullet", "dart", "ode")[2]);
  assert.deepEqual(colours("stiction", "bullet"), ["$ink", "$s0"]);
  know_engines([]);
});

test("a plot that cannot tell all curves apart keeps one of each configuration", () => {
  const curves = ["old", "old", "old", "paper", "paper", "paper", "paper", "paper", "quiet"].map(
    (configuration, i) => ({ configuration, i }),
  );
  const shown = told_apart(curves);
  assert.equal(shown.length, 7);
  assert.deepEqual(
    shown.map(({ i }) => i),
    [0, 1, 2, 3, 4, 5, 8],
  );
  assert.deepEqual(told_apart(curves.slice(0, 3)), curves.slice(0, 3));
});
