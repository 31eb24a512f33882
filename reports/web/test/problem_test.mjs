// SPDX-License-Identifier: GPL-3.0-or-later
// Problems in words and as drawings.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { drawing_html, read_problems } from "../make/drawing.mjs";
import { markup_of } from "../make/markup.mjs";
import { body_groups, problem_of, slope_of } from "../model/problem.js";
import { body_rows, direction_text, problem_facts, with_prefix } from "../model/problem_text.js";
import { case_command, record_command } from "../model/rerun.js";
import { turned } from "../model/vector.js";
import { cut_to_box, hatching, hull_of } from "../sketch/outline.js";
import { problem_sketch } from "../sketch/sketch.js";
import { view_of } from "../sketch/view.js";
import {
  body,
  BROKEN,
  clamp,
  incline,
  meshed,
  obstacle,
  problem,
  rolling,
  stack,
} from "./problems.mjs";
import { HOSTILE, record } from "./records.mjs";

const read = (value) => problem_of({ problem: value });
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} instead of ${b}`);
const facts = (value, rest) =>
  Object.fromEntries(
    problem_facts(read(value), rest).map(({ name, lines }) => [name, lines.join("\n")]),
  );

// All elements of a drawing with a class among whose words is `name`.
function found(node, name) {
  if (typeof node !== "object") return [];
  const own = String(node.attributes.class ?? "")
    .split(" ")
    .includes(name)
    ? [node]
    : [];
  return [...own, ...node.children.flatMap((child) => found(child, name))];
}
const text_of = (node) =>
  typeof node === "object" ? node.children.map(text_of).join(" ") : String(node);
const labels_of = (drawing) => found(drawing, "label").map(text_of);

test("what is no problem is none; what is broken in one does no harm", () => {
  for (const value of BROKEN) {
    const told = read(value);
    if (!told) continue;
    body_rows(told);
    problem_facts(told);
    const text = markup_of(problem_sketch(told).drawing);
    assert.doesNotMatch(text, /NaN|undefined|Infinity|\[object/);
  }
  assert.equal(read({ bodies: [] }), null);
  assert.equal(problem_of(record()), null);
});

test("a slope is gravity's end against what bodies stand on", () => {
  near(Math.tan(slope_of(read(incline())).angle), 0.4);
  assert.equal(slope_of(read(problem())), null);
  assert.equal(slope_of(read(clamp())), null, "nothing weighs");
  const tilted = problem({ obstacles: [obstacle({ normal: [0.6, 0, 0.8] })] });
  near(Math.tan(slope_of(read(tilted)).angle), 0.75);
  const upright = problem({ obstacles: [obstacle({ normal: [1, 0, 0] })] });
  assert.equal(slope_of(read(upright)), null, "a wall is no slope");
  // A slab that is held below, and no half-space.
  const held = { point: [0, 0, -0.05], normal: [0, 0, 1] };
  const slab = { ...incline(), obstacles: [], bodies: [body(), body({ name: "slab", held })] };
  near(Math.tan(slope_of(read(slab)).angle), 0.4);
});

test("the picture has gravity downwards and the slope falling to the right", () => {
  const { up, right, near: towards } = view_of(read(incline()));
  near(right[0], Math.cos(Math.atan(0.4)));
  assert.ok(up[0] < 0 && up[2] > 0);
  near(towards[1], -1);
});

test("jaws stand beside what they press, not before it", () => {
  const jaw = (y) => body({ name: "jaw", position: [0, y, 0.05] });
  const pressed = problem({
    bodies: [jaw(-0.3), body(), jaw(0.3)],
    springs: [
      { body: 1, anchor: [0.1, 0, 0], anchor_velocity: [0, 0, 0], axis: [1, 0, 0], stiffness: 1 },
    ],
  });
  near(Math.abs(view_of(read(pressed)).right[1]), 1);
});

test("equal bodies are one row, with density", () => {
  const told = read(stack(20));
  assert.equal(body_groups(told).length, 1);
  const [row] = body_rows(told);
  assert.match(row.name, /^20 boxes: box 1 … box 20$/);
  assert.equal(row.density, "1000");
  assert.equal(row.youngs_modulus, "500 kPa");
  assert.equal(row.damping, "1 ms");
  const mixed = problem({
    bodies: Array.from({ length: 9 }, (_, i) =>
      body({ name: `b${i}`, shape: { box: { size: [0.1 * (i + 1), 0.1, 0.1] } } }),
    ),
  });
  const rows = body_rows(read(mixed));
  assert.equal(rows.length, 1, "many groups of one material are told together");
  assert.match(rows[0].shape, /9 different boxes, longest edge 0\.1 to 0\.9 m/);
});

test("facts tell μ, gravity's turn, the slope, loads, springs, held parts, the start", () => {
  const slope = facts(incline(), { simulations: 48 });
  assert.match(slope.Obstacles, /‘plane’: μ = 0\.5, its face towards \+z, through the origin/);
  assert.match(
    slope.Gravity,
    /9\.81 m\/s², turned from −z to \(0\.3714, 0, −0\.9285\), between 0 and 1 s/,
  );
  assert.equal(slope.Slope, "θ = 21.8°, tan θ = 0.4");
  assert.match(slope.Simulations, /first of 48 simulations/);
  assert.equal(slope["Between bodies"], undefined);
  assert.equal(slope["At the start"], "all at rest");
  assert.equal(slope.Duration, "2 s");
  const pressed = facts(clamp());
  assert.equal(pressed.Gravity, "none");
  assert.equal(pressed["Between bodies"], "μ = 0.5");
  assert.match(
    pressed.Held,
    /‘left bar’: the part beyond its face towards \+x, moved up to 0\.001 m along \+x, from 0 to 0\.3 s/,
  );
  assert.equal(pressed.Loads, "force up to 2 N along −z, from 0 to 1 s, on ‘held’");
  const pushed = clamp();
  pushed.loads[0].force = {
    time: [0, 1, 2],
    value: [
      [0, 0, 0],
      [0, 0, 3],
      [0, 0, 0],
    ],
  };
  assert.equal(
    facts(pushed).Loads,
    "force for a while, at most 3 N along +z, from 0 to 2 s, on ‘held’",
  );
  assert.match(
    pressed.Springs,
    /100 N\/m along \+z from ‘held’ to an anchor at \(0, 0, 0\.3\) m that moves 0\.1 m\/s along \+z/,
  );
  assert.match(facts(rolling())["At the start"], /1 m\/s along \+x, spins at 10 rad\/s along \+y/);
});

test("numbers and directions are short", () => {
  assert.equal(with_prefix(2e9, "Pa"), "2 GPa");
  assert.equal(with_prefix(12, "Pa"), "12 Pa");
  assert.equal(direction_text([0, -3, 0]), "−y");
  assert.equal(direction_text([1, 1, 0]), "(0.7071, 0.7071, 0)");
});

test("a drawing has bodies, ground, gravity, the angle and dimensions in numbers", () => {
  const { drawing, caption } = problem_sketch(read(incline()), { title: "a case" });
  assert.equal(found(drawing, "body").length, 1);
  assert.equal(found(drawing, "ground").length, 1);
  assert.ok(found(drawing, "hatch").length > 10);
  assert.equal(found(drawing, "weight").length, 1);
  const labels = labels_of(drawing);
  for (const wanted of ["0.2 m", "0.1 m", "θ = 21.8°, tan θ = 0.4", "μ = 0.5", "g = 9.81 m/s²"])
    assert.ok(labels.includes(wanted), `${wanted} in ${labels}`);
  assert.match(caption, /turned so that gravity at its end points down/);
  assert.match(drawing.attributes["aria-label"], /of a case/);
});

test("it is to scale, and stays within its frame", () => {
  for (const value of [incline(), stack(), stack(20), rolling(), clamp(), meshed()]) {
    const { drawing } = problem_sketch(read(value));
    const [, , width, height] = drawing.attributes.viewBox.split(" ").map(Number);
    for (const { attributes } of found(drawing, "body")) {
      for (const pair of attributes.points?.split(" ") ?? []) {
        const [x, y] = pair.split(",").map(Number);
        assert.ok(x >= 0 && x <= width && y >= 0 && y <= height, `${value.name}: ${pair}`);
      }
    }
  }
  const [outline] = found(problem_sketch(read(stack(1))).drawing, "body");
  const points = outline.attributes.points.split(" ").map((pair) => pair.split(",").map(Number));
  const sizes = [0, 1].map((axis) => {
    const places = points.map((point) => point[axis]);
    return Math.max(...places) - Math.min(...places);
  });
  near(sizes[0], sizes[1]);
});

test("held parts are hatched; what moves, pushes and pulls has its mark and number", () => {
  const { drawing, key } = problem_sketch(read(clamp()));
  assert.ok(found(drawing, "held").length > 4);
  assert.equal(found(drawing, "spring").length, 1);
  assert.deepEqual(key.map(([name]) => name).sort(), ["force", "motion", "spring"]);
  const labels = labels_of(drawing);
  for (const wanted of ["2 N", "k = 100 N/m", "moved 0.001 m"])
    assert.ok(labels.includes(wanted), `${wanted} in ${labels}`);
  const ball = problem_sketch(read(rolling()));
  assert.equal(found(ball.drawing, "body")[0].tag, "circle");
  assert.ok(labels_of(ball.drawing).includes("⌀ 0.2 m"));
  assert.ok(labels_of(ball.drawing).includes("10 rad/s"));
});

test("a mesh is drawn as its box, or as a recording has it", () => {
  const told = read(meshed());
  const boxed = problem_sketch(told);
  assert.equal(found(boxed.drawing, "bounding").length, 1);
  assert.match(boxed.caption, /dashed: the box around a mesh/);
  const vertices = [
    [0, 0, 0],
    [0.1, 0, 0],
    [0, 0, 0.1],
  ];
  const surfaces = new Map([[0, { vertices, triangles: [0, 1, 2] }]]);
  const real = problem_sketch(told, { surfaces });
  assert.equal(found(real.drawing, "bounding").length, 0);
  assert.match(found(real.drawing, "edges")[0].attributes.d, /^M/);
  assert.doesNotMatch(real.caption, /dashed/);
});

test("names are text in the drawing's markup", () => {
  const { drawing } = problem_sketch(read({ ...incline(), bodies: [body({ name: HOSTILE })] }), {
    title: HOSTILE,
  });
  assert.doesNotMatch(markup_of(drawing), /<(img|script)/);
});

test("hulls, cuts and hatching", () => {
  const square = hull_of([
    [0, 0],
    [2, 0],
    [2, 2],
    [0, 2],
    [1, 1],
  ]);
  assert.equal(square.length, 4);
  const part = cut_to_box(square, [1, -1, 3, 3]);
  assert.equal(Math.min(...part.map(([x]) => x)), 1);
  const lines = hatching(square, 0.5);
  assert.ok(lines.length >= 4);
  for (const [a, b] of lines)
    for (const [x, y] of [a, b]) assert.ok(x > -1e-9 && x < 2 + 1e-9 && y > -1e-9 && y < 2 + 1e-9);
  const turn = turned([Math.SQRT1_2, 0, 0, Math.SQRT1_2], [1, 0, 0]); // by 90° about z
  near(turn[1], 1);
});

test("commands that run a case again can be pasted into a shell", () => {
  assert.equal(case_command(record()), "./stiction validate --case 'incline/stop/mu=0.3'");
  assert.equal(
    case_command({ case: "it's", engine: "bullet" }),
    "./stiction validate --case 'it'\\''s' --engine 'bullet'",
  );
  assert.equal(
    case_command({ case: "user/a[1]*b", engine: "bullet" }),
    "./stiction validate PROBLEM.toml --case 'user/a?1??b' --engine 'bullet'",
  );
  for (const [name, command] of [
    ["bench/slab/contacts=1000", "bench --benchmark_filter='/slab/contacts:1000$'"],
    ["bench/slab/scaling", "bench --benchmark_filter='/slab/'"],
    ["bench/features", "bench"],
    ["sizes/slab", "track sizes --against '0123' --benchmark 'step/slab/*'"],
    ["trend/step/slab/contacts:100", "track history --metric 'step/slab/contacts:100#*'"],
  ]) {
    const other = { ...record(), case: name, settings: { before: "0123" }, configuration: "now" };
    assert.equal(case_command(other), `./stiction ${command}`);
    assert.equal(record_command(other), "");
  }
  assert.equal(
    case_command({ ...record(), case: "constructor/x" }),
    "./stiction validate --case 'constructor/x'",
  );
  assert.equal(record_command(record()), "");
  assert.equal(
    record_command({ ...record(), configuration: "paper, secant", differs: { kappa: "0.7" } }),
    "./stiction validate --case 'incline/stop/mu=0.3' --configuration 'paper, secant' --set 'kappa=0.7'",
  );
});

test("what swings and what moves steadily is told", () => {
  const oscillation = { amplitude: [1e-3, 0, 0], frequency: 5, phase: 0, begins: 0, full_from: 0 };
  const swings = { time: [], value: [], oscillation };
  const told = facts({
    ...problem(),
    obstacles: [
      { ...obstacle(), name: "table", motion: swings },
      { ...obstacle(), name: "belt", motion: { time: [], value: [], velocity: [0, 0.2, 0] } },
    ],
    gravity: { time: [0], value: [[0, 0, -9.81]], oscillation },
  });
  assert.match(told.Obstacles, /‘table’.*moved to and fro by 0\.001 m along \+x at 5 Hz/);
  assert.match(told.Obstacles, /‘belt’.*moved steadily by 0\.2 m\/s along \+y/);
  assert.match(told.Gravity, /9\.81 m\/s² along −z, to and fro by 0\.001 m\/s² along \+x at 5 Hz/);
});

test("problems that were read and not run are drawn, with their data and as text alone", () => {
  const html = drawing_html(
    [
      { case: "user/ramp", title: HOSTILE, problem: incline() },
      { case: "user/none", title: "nothing", problem: {} },
    ],
    "p {}",
  );
  assert.match(html, /<h2>user\/ramp<\/h2>/);
  assert.match(html, /class="sketch"/);
  assert.match(html, /does not tell the problem/);
  assert.ok(!html.includes(HOSTILE));
});

test("a folder of problems is read, and what is none is told of in a sentence", () => {
  const folder = mkdtempSync(join(tmpdir(), "problems-"));
  assert.equal(read_problems(folder), null);
  writeFileSync(join(folder, "problems.json"), "[1");
  assert.throws(() => read_problems(folder), /problems\.json is no list of problems/);
  writeFileSync(join(folder, "problems.json"), "[]");
  assert.deepEqual(read_problems(folder), []);
  rmSync(folder, { recursive: true });
});
