// SPDX-License-Identifier: GPL-3.0-or-later
// Records of sweeps for tests and pictures: a box on a ramp that holds where its friction does.
//   node reports/web/test/sweep_records.mjs FOLDER: a run of each kind there
import { mkdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { check, lines_of, record } from "./records.mjs";

export const MACHINES = {
  a: { machine: "Example CPU, 2 cores", toolchain: "GCC 12.2.0, Release", host: "node-1" },
  b: { machine: "Other CPU, 64 cores", toolchain: "GCC 12.2.0, Release", host: "node-2" },
};

const UNITS = { "ramp.slope_deg": "deg", "body.mass": "kg", "engine.dt": "s", "body.size": "m" };

/** What ran where: the environment of a record. */
export const on = (machine) => ({ environment: { ...record().environment, ...MACHINES[machine] } });

/** A point of a sweep over `axes`, {name: value}. */
export function point(axes, change = {}) {
  const entries = Object.entries(axes);
  return record({
    case: ["user/box", ...entries.map(([name, value]) => `${name}=${value}`)].join("/"),
    point: "0123456789abcdef",
    axes: entries.map(([name, value]) => ({
      name,
      value,
      unit: UNITS[name] ?? (name.endsWith("_deg") ? "deg" : "1"),
    })),
    ...change,
  });
}

/** What came out at a point: it slides where the slope is too steep, and breaks off where Δt is too large. */
export function measured(axes, { machine = "a", change = {} } = {}) {
  const friction = axes["ramp.friction"] ?? 0.5;
  const slope = ((axes["ramp.slope_deg"] ?? 20) * Math.PI) / 180;
  const mass = axes["body.mass"] ?? 1;
  const dt = axes["engine.dt"] ?? 1e-4;
  const broke = dt * Math.sqrt(1 / mass) > 1.5e-3;
  const excess = Math.sin(slope) - friction * Math.cos(slope);
  const speed = excess > 0 ? 9.81 * excess : 1e-9 * Math.exp(6 + 20 * excess) * mass;
  const lost = !broke && slope > 0.7 && friction < 0.15;
  const holds = speed < 1e-6;
  return point(axes, {
    ...on(machine),
    verdict: broke ? "error" : holds && !lost ? "pass" : "fail",
    error: broke ? "the solver diverged" : "",
    series: [],
    cost: {
      ...record().cost,
      cpu_seconds: (machine === "a" ? 1 : 0.3) * (2e-5 / dt) * (1 + mass) * (excess > 0 ? 2 : 1),
    },
    checks: broke
      ? []
      : [
          check({
            quantity: "mean velocity downhill",
            unit: "m/s",
            expected: 0,
            relative: false,
            scale: undefined,
            tolerance: 1e-6,
            value: lost ? "nan" : speed,
            error: lost ? "nan" : speed,
            digits: undefined,
            of_tolerance: lost ? "inf" : speed * 1e6,
            verdict: holds && !lost ? "pass" : "fail",
          }),
          check({
            quantity: "normal force",
            unit: "N",
            expected: 9.81 * mass * Math.cos(slope),
            value: 9.81 * mass * Math.cos(slope) * (1 + 1e-5 * friction),
            tolerance: 1e-3,
          }),
        ],
    ...change,
  });
}

/** All combinations of `axes`, {name: [values]}. */
export const grid = (axes) =>
  Object.entries(axes).reduce(
    (points, [name, values]) =>
      points.flatMap((one) => values.map((value) => ({ ...one, [name]: value }))),
    [{}],
  );

/** `count` scattered points of `axes`, {name: [from, to]}, the same each time. */
export function scattered(axes, count) {
  const roots = [2, 3, 5, 7, 11, 13].map(Math.sqrt);
  return Array.from({ length: count }, (_, i) =>
    Object.fromEntries(
      Object.entries(axes).map(([name, [from, to]], k) => [
        name,
        from + (to - from) * (((i + 1) * roots[k]) % 1),
      ]),
    ),
  );
}

export const steps = (from, to, count) =>
  Array.from({ length: count }, (_, i) =>
    Number((from + ((to - from) * i) / (count - 1)).toPrecision(6)),
  );

export const FRICTION_AND_SLOPE = {
  "ramp.friction": steps(0.1, 0.9, 17),
  "ramp.slope_deg": steps(3, 45, 15),
};
const RANGES = {
  "ramp.friction": [0.1, 0.9],
  "ramp.slope_deg": [3, 45],
  "body.mass": [0.1, 10],
  "engine.dt": [1e-5, 1e-3],
};
const pick = (names) => Object.fromEntries(names.map((name) => [name, RANGES[name]]));

/** Runs to be looked at: {name: records}. */
export const runs = () => ({
  two: grid(FRICTION_AND_SLOPE).map((axes) => measured({ ...axes })),
  three: grid({ ...FRICTION_AND_SLOPE, "engine.dt": [1e-5, 1e-4, 3e-4, 1e-3, 3e-3] }).map((axes) =>
    measured(axes),
  ),
  scattered: scattered(pick(["ramp.friction", "ramp.slope_deg"]), 400).map((axes) =>
    measured(axes),
  ),
  "scattered-three": scattered(pick(["ramp.friction", "ramp.slope_deg", "body.mass"]), 500).map(
    (axes) => measured(axes),
  ),
  four: scattered(RANGES, 700).map((axes) => measured(axes)),
  "two-machines": grid(FRICTION_AND_SLOPE).map((axes, i) =>
    measured(axes, { machine: i % 3 ? "a" : "b" }),
  ),
  "one-axis": grid({ "ramp.slope_deg": steps(3, 45, 29) }).flatMap((axes) => [
    measured(axes, { machine: axes["ramp.slope_deg"] < 20 ? "a" : "b" }),
  ]),
});

if (process.argv[1] && resolve(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const folder = process.argv[2];
  for (const [name, records] of Object.entries(runs())) {
    mkdirSync(join(folder, name), { recursive: true });
    writeFileSync(join(folder, name, "records.jsonl"), lines_of(records));
  }
}
