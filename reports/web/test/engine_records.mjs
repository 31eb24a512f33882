// SPDX-License-Identifier: GPL-3.0-or-later
// Engines side by side, as `./stiction compare engines` writes them: raw answers, what they come to, and
// the findings. Some answers break, some engines lack what it takes, one never gets there.
import { check, record } from "./records.mjs";

const ENGINES = [
  ["bullet", ["default", "best"]],
  ["bullet-deformable-finite-elements", ["implicit", "solver=projected-gauss-seidel step=0.001"]],
  ["dart", ["default", "dantzig"]],
  ["mujoco", ["default", "elliptic-noslip"]],
  ["ode", ["quick", "exact"]],
  ["siconos", ["nsgs"]],
  ["stiction", ["default"]],
  ["minimal-python", ["default"]],
  ["minimal", ["default"]],
];

export const ROWS = ENGINES.flatMap(([engine, names]) =>
  names.map((configuration) => ({ engine, configuration })),
);

export const row_name = ({ engine, configuration }) => `${engine} · ${configuration}`;

const UNITS = ["m/s", "°", "1"];
const EFFORTS = 4;

export const QUESTIONS = Array.from({ length: 25 }, (_, i) => ({
  id: `question-${i}`,
  title: i % 3 === 1 ? `… falling to ${i}°` : `Does it hold in scene ${i}? Falling to ${i}°`,
  case_name: `slope/scene-${i}/azimuth=${i}`,
  unit: UNITS[i % 3],
  curve: i % 2 === 0,
}));

/** What an engine says to a question: "told", "never", "broke" or "lacks". */
export function kind_of(row, question) {
  if ((row + 3 * question) % 29 === 7) return "broke";
  if ((row + question) % 17 === 5) return "lacks";
  return row === 4 && question % 3 === 1 ? "never" : "told";
}

const rounded = (value) => Number(value.toPrecision(3));

function error_of(row, question, effort) {
  if (kind_of(row, question) === "never") return "nan";
  if (row === 12 && question % 5 === 0) return 0;
  const size = 10 ** (((row * 5 + question * 3) % 13) - 13 - 0.6 * effort);
  const sign = QUESTIONS[question].unit !== "m/s" && (row + question) % 2 === 0 ? -1 : 1;
  return rounded(sign * size);
}

const seconds_of = (row, question, effort) =>
  rounded(1e-4 * (row + 1) ** 2 * 2 ** (effort + (question % 4)));

// The last effort of one row in four breaks.
const breaks = (row, question, effort) =>
  kind_of(row, question) === "broke" || (effort === EFFORTS - 1 && row % 4 === 1);

const BROKEN = "it was killed by signal 11: bt_solver.cpp: assertion failed";
const LACKED = "the engine turns no bodies";

function answers(question, i) {
  return ROWS.flatMap((row, k) =>
    Array.from({ length: question.curve ? EFFORTS : 1 }, (_, effort) => {
      const kind = kind_of(k, i);
      const broken = kind !== "lacks" && breaks(k, i, effort);
      const verdict =
        kind === "lacks" ? "not-applicable" : broken ? "error" : k % 3 === 0 ? "fail" : "pass";
      const error = error_of(k, i, effort);
      const of_tolerance = k % 3 === 0 ? 3 : 0.5;
      return record({
        case: question.case_name,
        title: `a box in scene ${i}`,
        engine: row.engine,
        settings: {
          configuration: row.configuration,
          dt: String(0.01 / 2 ** effort),
          effort: String(effort),
        },
        verdict,
        error: broken ? BROKEN : "",
        checks:
          broken || kind === "lacks"
            ? []
            : [
                check({
                  quantity: "creep",
                  value: error,
                  expected: 0,
                  error,
                  of_tolerance,
                  verdict,
                }),
              ],
        notes: kind === "lacks" ? [LACKED] : [],
        cost: { ...record().cost, cpu_seconds: seconds_of(k, i, effort) },
      });
    }),
  );
}

function summary(row, k, question, i) {
  const kind = kind_of(k, i);
  const figure = (quantity, unit, value) => ({
    quantity,
    unit,
    meaning: "how far off, relative: a",
    value,
  });
  const efforts = Array.from({ length: question.curve ? EFFORTS : 0 }, (_, effort) => effort);
  const told = kind === "lacks" ? [] : efforts.filter((effort) => !breaks(k, i, effort));
  const untold = efforts.filter((effort) => !told.includes(effort));
  return record({
    case: `engines/${question.id}`,
    title: question.title,
    engine: row.engine,
    settings: { configuration: row.configuration, dt: "0.01", effort: "0" },
    variant: `configuration=${row.configuration}`,
    verdict: kind === "lacks" ? "not-applicable" : "for-information",
    checks: [],
    figures:
      kind === "told" || kind === "never"
        ? [
            figure("error", question.unit, error_of(k, i, 0)),
            figure("CPU time", "s", seconds_of(k, i, 0)),
          ]
        : [],
    failures: [
      ...(kind === "broke" ? [{ reason: BROKEN, parameter: "", values: [] }] : []),
      ...untold.map((effort) => ({
        reason: kind === "lacks" ? "" : BROKEN,
        parameter: "effort",
        values: [effort],
      })),
    ],
    notes: [
      `again: ./stiction validate --engine '${row.engine}' --case '${question.case_name}' --set dt=0.01`,
      ...(kind === "lacks" ? [LACKED] : []),
    ],
    series:
      told.length === 0
        ? []
        : [
            {
              name: "error",
              unit: question.unit,
              x_name: "CPU time",
              x_unit: "s",
              x: told.map((effort) => seconds_of(k, i, effort)),
              y: told.map((effort) => {
                const error = error_of(k, i, effort);
                return typeof error === "number" ? Math.abs(error) : error;
              }),
            },
          ],
  });
}

export const ENGINE_FINDINGS = [
  ...QUESTIONS.slice(0, 12).map(
    ({ id }) => `${id}: closer to the right answer than ours (-4e-14): bullet · default (-2e-14)`,
  ),
  "question-2: an error below 0.01 costs 1.1 ms with ode · quick, 230 times as much with ours",
  "Hold up to 0.01° below the critical slope: stiction · default",
  "Broke on a question: bullet · default",
];

export const engine_records = () => [
  ...QUESTIONS.flatMap(answers),
  ...QUESTIONS.flatMap((question, i) => ROWS.map((row, k) => summary(row, k, question, i))),
  record({
    case: "engines/findings",
    title: "what the engines' answers say",
    engine: "",
    settings: {},
    verdict: "for-information",
    checks: [],
    notes: ENGINE_FINDINGS,
  }),
];
