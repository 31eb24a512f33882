// SPDX-License-Identifier: GPL-3.0-or-later
// A small comparison, as `./stiction compare` writes it.
import { check, record } from "./records.mjs";

export const figure = (quantity, unit, value) => ({
  quantity,
  unit,
  meaning: "little is better",
  value,
});

const failures_of = (failed, reason) => (failed ? [{ reason, parameter: "", values: [] }] : []);

const hash_check = () =>
  check({
    quantity: "state hash differs",
    unit: "1",
    claim: "both are one",
    value: 0,
    expected: 0,
    error: 0,
    scale: undefined,
    tolerance: 0,
    of_tolerance: 0,
    digits: undefined,
  });

export const RULES = ["aitken-vector", "conjugate-vector", "fixed-point", "none", "secant"];
const CONTACTS = ["paper", "quiet"];
const READINGS = [
  ...RULES.map((rule) => ({
    rule,
    ...(rule === "fixed-point" && { gain: "0.7", memory: "reset" }),
    set: { rule },
  })),
  {
    rule: "fixed-point",
    alpha: "-0.1",
    memory: "reset",
    set: { alpha: "-0.1", rule: "fixed-point" },
  },
  {
    rule: "fixed-point",
    gain: "0.7",
    memory: "keep",
    set: { memory: "keep", rule: "fixed-point" },
  },
];
const STEPS = [1, 2, 5, 10, 100, 1000];

const variant_of = (set) =>
  Object.entries(set)
    .map(([name, value]) => `${name}=${value}`)
    .join(" ");

const on_contacts = (make) =>
  CONTACTS.flatMap((method, on) =>
    READINGS.map(({ set, ...resolved }, i) => ({
      ...make({ method, ...resolved }, i, on),
      variant: variant_of({ method, ...set }),
    })),
  );

function history(scene, fails) {
  return on_contacts((settings, i, on) => {
    const creep = 10 ** -(3 + i + 5 * on);
    const failed = fails(settings);
    return record({
      case: `rules/${scene}`,
      title: `a scene called ${scene}`,
      settings,
      checks: [hash_check()],
      figures: [
        figure("steps to 1e-6", "1", creep < 1e-6 && !failed ? 10 + i : "inf"),
        figure("final creep", "m/s", creep),
      ],
      failures: failures_of(failed, "a body moved by 7.6 mm"),
      series: [
        {
          name: "mean contact slip",
          unit: "m/s",
          x_name: "step",
          x_unit: "1",
          x: STEPS,
          y: STEPS.map((step) => (creep * 1000) / step),
        },
      ],
    });
  });
}

const sweep = () =>
  ["fixed-point", "secant"].map((rule, i) =>
    record({
      case: "gain/slab",
      settings: { method: "paper", rule, memory: "keep" },
      variant: variant_of({ memory: "keep", method: "paper", rule }),
      checks: [hash_check()],
      figures: [figure("least final creep", "m/s", 1e-5 * (i + 1))],
      failures: i === 1 ? [{ reason: "it broke", parameter: "gain", values: [-0.5, 2.5] }] : [],
      series: [
        {
          name: "final creep",
          unit: "m/s",
          x_name: "gain",
          x_unit: "1",
          x: i === 1 ? [0, 1] : [-0.5, 0, 1, 2.5],
          y: i === 1 ? [2e-5, 3e-5] : [1e-3, 1e-5, 1e-5, 1e-3],
        },
      ],
    }),
  );

// Each rule a hundredfold more precise than the one before; "none" fails at the largest step.
const work = () =>
  ["2e-4", "1e-4"].flatMap((dt, finer) =>
    [2, 3].flatMap((cells) =>
      on_contacts((settings, i, on) => {
        const failed = settings.rule === "none" && finer === 0;
        const seconds = 0.01 * cells * (1 + finer) * (1 + 0.1 * i);
        return record({
          case: `work/slab/cells=${cells}/dt=${dt}`,
          settings: { ...settings, dt },
          checks: [],
          figures: [
            figure("slipped ÷ free slide", "1", failed ? "inf" : 10 ** -(2 + 2 * i + on)),
            figure("CPU time", "s", seconds),
          ],
          failures: failures_of(failed, "the box slid off"),
          cost: { ...record().cost, cpu_seconds: seconds },
        });
      }),
    ),
  );

export const FINDINGS = [
  "Fixed point against secant on paper contacts: comparable.",
  "No rule beats both.",
  "rules/slab: 1e-9 m/s within 50 steps by none.",
];

export const compared_records = () => [
  ...["slab", "clamp", "membrane"].flatMap((scene) =>
    history(scene, ({ rule }) => scene === "membrane" && rule === "secant"),
  ),
  ...history("ball", () => true),
  ...sweep(),
  ...work(),
  record({
    case: "findings",
    settings: {},
    verdict: "not-applicable",
    checks: [],
    notes: FINDINGS,
  }),
];
