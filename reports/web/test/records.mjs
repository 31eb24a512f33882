// SPDX-License-Identifier: GPL-3.0-or-later
// Records and runs for tests.
import { copyFileSync, mkdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { temporary_folder } from "./temporary.mjs";

const FRAMES = join(dirname(fileURLToPath(import.meta.url)), "data", "sliding-box.bin");

export function check(change = {}) {
  return {
    quantity: "stopping distance",
    unit: "m",
    claim: "a sliding box stops",
    formula: "d = v₀²/(2μg)",
    source: "Coulomb's law",
    kind: "analytic",
    value: 0.3001,
    expected: 0.3,
    error: 3.3e-4,
    relative: true,
    scale: 0.3,
    of_tolerance: 0.33,
    tolerance: 1e-3,
    reason: "half a step of travel",
    digits: 3.5,
    worst: "",
    cause: "",
    verdict: "pass",
    ...change,
  };
}

/** A check and a record as schema version 3 wrote them. */
export function old_check(change = {}) {
  const { of_tolerance, ...old } = check(change);
  return old;
}

export function old_record(change = {}) {
  const { figures, failures, ...old } = record({ schema_version: 3, ...change });
  return old;
}

export function record(change = {}) {
  return {
    schema_version: 4,
    case: "incline/stop/mu=0.3",
    title: "a box stops",
    engine: "stiction",
    settings: { dt: "0.001", rule: "fixed-point" },
    verdict: "pass",
    error: "",
    checks: [check()],
    figures: [],
    failures: [],
    notes: [],
    cost: {
      cpu_seconds: 0.25,
      steps: 1000,
      contact_updates: 4000,
      simulated_seconds: 0.1,
      ns_per_contact_update: 25,
      ns_per_contact_update_quartiles: [24, 27],
      ns_per_contact_step: 210,
      ns_per_contact_step_quartiles: [205, 220],
      phase_seconds: { detect: 0.05, friction: 0.15 },
    },
    state_hash: "0123456789abcdef",
    environment: {
      revision: "4f2a9c1",
      toolchain: "g++ 12",
      machine: "a machine",
      date: "2025-11-20T23:41:05Z",
    },
    series: [],
    ...change,
  };
}

const over = (count, y_of) => ({
  x: Array.from({ length: count }, (_, i) => 0.01 * (i + 1)),
  y: Array.from({ length: count }, (_, i) => y_of(0.01 * (i + 1))),
});

/** A run that has something of everything the page shows. */
export function varied_records() {
  const rules = ["fixed-point", "none"];
  const stop = rules.map((rule, i) =>
    record({
      settings: { dt: "0.001", rule },
      frames: "frames/box.bin",
      series: [
        {
          name: "kinetic energy",
          unit: "J",
          x_name: "time",
          x_unit: "s",
          ...over(60, (t) => Math.exp(-30 * t) * (1 + 0.1 * i)),
        },
        {
          name: "distance error",
          unit: "m",
          x_name: "time step",
          x_unit: "s",
          x: [0.004, 0.002, 0.001],
          y: [4e-4, 2e-4, 1e-4],
        },
        {
          name: "contact phases",
          unit: "s",
          x_name: "contacts",
          x_unit: "1",
          x: [100, 1000, 10000],
          y: [1e-5, 1e-4, 1e-3],
        },
      ],
      cost: { ...record().cost, cpu_seconds: 0.2 + 0.1 * i },
      checks: [check({ digits: 3.5 + i, of_tolerance: 0.33 / 10 ** i })],
    }),
  );
  const thresholds = [0.1, 0.3, 0.5].map((mu) =>
    record({
      case: `incline/threshold/mu=${mu}`,
      title: `critical slope at μ = ${mu}`,
      checks: [
        check({
          quantity: "critical tan θ",
          unit: "1",
          claim: "sticks if and only if tan θ ≤ μ",
          value: mu * (1 - 1e-9),
          expected: mu,
          error: -1e-9,
          scale: mu,
          of_tolerance: 0.1,
          tolerance: 1e-8,
          digits: 9,
        }),
      ],
      notes: [
        `bracket on tan θ: holds at ${mu * (1 - 3e-9)}, slides at ${mu * (1 + 1e-9)}; 28 runs`,
      ],
    }),
  );
  const failing = record({
    case: "clamp/hold",
    title: "a clamped box",
    verdict: "fail",
    checks: [
      check({
        quantity: "creep",
        unit: "m/s",
        value: 2e-3,
        expected: 0,
        error: 2e-3,
        relative: false,
        scale: undefined,
        tolerance: 1e-6,
        of_tolerance: 2000,
        digits: undefined,
        verdict: "fail",
        worst: "corner 3",
      }),
      check(),
    ],
  });
  const broken = record({
    case: "pyramid/four-balls",
    verdict: "error",
    error: "the solver diverged at t = 0.2 s",
    checks: [],
  });
  const shown = record({
    case: "membrane/ball",
    verdict: "for-information",
    checks: [check({ verdict: "for-information" })],
  });
  const skipped = record({ case: "basket/balls", verdict: "not-applicable", checks: [] });
  const odd = record({
    case: "drop/odd",
    checks: [
      check({ value: "nan", error: "inf", of_tolerance: "inf", digits: 0, verdict: "fail" }),
    ],
    verdict: "fail",
  });
  return [...stop, ...thresholds, failing, broken, shown, skipped, odd];
}

export const HOSTILE = `<img src=x onerror="globalThis.hacked=1">&amp;"'</script><script>globalThis.hacked=1</script>\u2028\u202e{{7*7}}$pass`;

export function hostile_records() {
  return [0, 1].map((i) =>
    record({
      case: `${HOSTILE}/case=${HOSTILE}`,
      title: HOSTILE,
      engine: HOSTILE,
      settings: { [HOSTILE]: `${HOSTILE}${i}` },
      notes: [HOSTILE, "__proto__"],
      state_hash: HOSTILE,
      environment: { revision: HOSTILE, toolchain: HOSTILE, machine: HOSTILE, date: HOSTILE },
      checks: [
        check({
          quantity: `critical ${HOSTILE}`,
          unit: HOSTILE,
          claim: HOSTILE,
          formula: HOSTILE,
          source: HOSTILE,
          reason: HOSTILE,
          worst: HOSTILE,
        }),
      ],
      series: [
        {
          name: HOSTILE,
          unit: HOSTILE,
          x_name: "time",
          x_unit: HOSTILE,
          x: [1, 2, 3],
          y: [1, 2, "nan"],
        },
        { name: "constructor", unit: "1", x_name: "__proto__", x_unit: "1", x: [1, 2], y: [3, 4] },
      ],
      cost: { ...record().cost, phase_seconds: { [HOSTILE]: 1, toString: 2 } },
      frames: "../../../../etc/passwd",
    }),
  );
}

export const lines_of = (records) => records.map((one) => `${JSON.stringify(one)}\n`).join("");

/** A run's folder with a records.jsonl of `text`. */
export function make_run(text, name = "run") {
  const folder = join(temporary_folder(), name);
  mkdirSync(join(folder, "frames"), { recursive: true });
  copyFileSync(FRAMES, join(folder, "frames", "box.bin"));
  writeFileSync(join(folder, "records.jsonl"), text);
  return folder;
}
