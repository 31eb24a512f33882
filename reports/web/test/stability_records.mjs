// SPDX-License-Identifier: GPL-3.0-or-later
// Records of ./stiction validate --suite stability for tests: perturbed cases and ladders of several
// configurations and engines.
import { check, record } from "./records.mjs";

const WORSE = { pass: 0, fail: 1 };

/** A group's check: σ/scale `value`, allowed `tolerance`. */
export function survived(quantity, value, { tolerance = 1e-10, worst = "" } = {}) {
  const size = value === "inf" ? Infinity : value;
  return check({
    quantity,
    unit: "1",
    claim: `nothing depends on "${quantity}"`,
    value,
    expected: 0,
    error: value,
    relative: false,
    scale: 1,
    tolerance,
    of_tolerance: size === Infinity ? "inf" : size / (tolerance || 1),
    digits: size === 0 ? 16 : Math.min(16, Math.max(0, -Math.log10(size))),
    worst,
    verdict: size <= tolerance ? "pass" : "fail",
  });
}

const verdict_of = (checks) =>
  checks.reduce((a, b) => (WORSE[b.verdict] > WORSE[a] ? b.verdict : a), "pass");

export const perturbed = (name, checks, change = {}) =>
  record({
    case: `perturbed/${name}`,
    title: `${name}: how many digits survive`,
    configuration: "quiet",
    verdict: verdict_of(checks),
    checks,
    ...change,
  });

/** A rung whose deciding check is at `ratio` × its tolerance. */
export function rung(name, ratio, change = {}) {
  const size = ratio === "inf" ? Infinity : ratio;
  const verdict = size <= 1 ? "pass" : "fail";
  const [, ladder, parameter, value] = /^(.*)\/(.*)=(.*)$/.exec(name);
  return record({
    case: `ladder/${name}`,
    title: `something is ${ladder}: ${parameter} = ${value}`,
    configuration: "quiet",
    frames: "frames/box.bin",
    verdict,
    checks: [
      check({ quantity: "drift at rest", of_tolerance: 1e-9, digits: undefined }),
      check({ quantity: "contact slip", of_tolerance: ratio, verdict, worst: "box 3" }),
    ],
    ...change,
  });
}

const LACKING =
  "bodies renumbered: not applicable: there are too few bodies to put in another order";

function perturbed_of(change) {
  const turned = "height: 1 m, not 2, when turned by 40° about (1, 2, 3)";
  return [
    perturbed(
      "fall",
      [survived("rerun", 0), survived("turned", 2e-15), survived("other units", 0)],
      {
        notes: [LACKING],
        ...change,
      },
    ),
    perturbed(
      "stack/rest/n=2",
      [
        survived("rerun", 0),
        survived("turned", 3e-7, { worst: turned }),
        survived("bodies renumbered", "inf", {
          worst: "bodies and obstacles in another order, seed 2: it broke off",
        }),
        survived("other units", 4e-13, { worst: "told by nobody" }),
      ],
      change,
    ),
  ];
}

const LADDERS = {
  "mass-ratio/top": [
    [1, 1e-8],
    [10, 1e-7],
    [100, 1e-3],
    [1000, 30],
    [10000, 0.5],
    [1e6, "inf"],
  ],
  "touching/gap": [
    [-1e-12, 3],
    [-1e-15, 0.2],
    [0, 0],
    [1e-15, 0],
    [1e-9, 1e-20],
  ],
};

function ladders_of(change, weaker = 1) {
  return Object.entries(LADDERS).flatMap(([name, rungs]) =>
    rungs.map(([value, ratio]) => {
      const own = typeof ratio === "number" ? ratio * weaker : ratio;
      return rung(`${name}=${value}`, own, change);
    }),
  );
}

/** Two configurations of ours, another engine, which breaks off and lacks something. */
export function stability_records() {
  const other = { engine: "other", configuration: "quick" };
  const broke = { ...other, verdict: "error", error: "it exploded", checks: [] };
  return [
    ...perturbed_of({}),
    ...ladders_of({}),
    ...perturbed_of({ configuration: "paper, secant" }),
    ...ladders_of({ configuration: "paper, secant" }, 1e5),
    perturbed("fall", [survived("rerun", 0), survived("turned", 0)], other),
    perturbed("stack/rest/n=2", [], broke),
    ...ladders_of(other, 1e-3).slice(0, 4),
    rung("mass-ratio/top=10000", 1, broke),
    rung("touching/gap=0", 1, {
      ...other,
      verdict: "not-applicable",
      checks: [],
      notes: ["no gaps"],
    }),
    ...[0.1, 1].map((load) => rung(`cone/load=${load}`, load)),
    record({ case: "gauntlet/hook", title: "a hook", configuration: "quiet" }),
  ];
}
