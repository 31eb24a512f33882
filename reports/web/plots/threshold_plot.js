// SPDX-License-Identifier: GPL-3.0-or-later
// Critical values with their brackets: where it still holds, where it gives way, and how far from the
// expected value that is.
import { margin, value_text, expected_text } from "../model/check_text.js";
import { to_number } from "../model/number.js";
import { rounded } from "./axes.js";
import { name_axis, numbered, tip, tip_number } from "./names.js";
import { verdict_encoding } from "./palette.js";

const MOST_ROWS = 40;
// "holds at 0.4999, slides at 0.5001", "stands at tan θ = 0.30, breaks at 0.31", "holds at N = 9.8 N, …"
const END = String.raw`at (?:[^,\d]*= )?([-+]?\d[\d.]*(?:e[-+]?\d+)?)`;
const BRACKET_NOTE = new RegExp(
  `(?:holds|stands) ${END}[^,]*, (?:slides|fails|breaks) ${END}`,
  "i",
);

/** {holds, fails} as a note tells it; null when it doesn't. */
export function bracket_in(note) {
  const found = BRACKET_NOTE.exec(note);
  return found && { holds: Number(found[1]), fails: Number(found[2]) };
}

export const is_threshold = (check) =>
  /^(critical|threshold)\b/i.test(check.quantity) && check.verdict !== "not-applicable";

// {holds, fails} of a record's only threshold: as the note gives it, else from the bracket's width.
function bracket_of(record, check) {
  const told = record.notes.map(bracket_in).find(Boolean);
  if (told) return told;
  const width = record.checks.find(({ quantity }) => quantity === "bracket width");
  if (!width) return null;
  const half = to_number(width.value) / 2;
  return { holds: to_number(check.value) - half, fails: to_number(check.value) + half };
}

/** `entries`: [{label, record}]. Null when no check is a threshold. */
export function threshold_plot(entries) {
  const rows = entries
    .flatMap(({ label, record }) => {
      const checks = record.checks.filter(is_threshold);
      return checks.map((check) => {
        const allowed =
          to_number(check.tolerance) * (check.relative ? Math.abs(to_number(check.scale)) : 1);
        const in_tolerances = (value) => rounded((value - to_number(check.expected)) / allowed);
        const bracket = checks.length === 1 ? bracket_of(record, check) : null;
        return {
          row: checks.length === 1 ? label : `${label} ${check.quantity}`.trim(),
          case: record.case,
          at: in_tolerances(to_number(check.value)),
          holds: bracket && in_tolerances(bracket.holds),
          fails: bracket && in_tolerances(bracket.fails),
          verdict: check.verdict,
          measured: value_text(check),
          expected: expected_text(check),
          margin: margin(check),
          allowed,
        };
      });
    })
    .filter(({ at, allowed }) => at !== null && allowed > 0);
  if (rows.length === 0) return null;
  const shown =
    rows.length <= MOST_ROWS
      ? rows
      : [...rows].sort((a, b) => b.margin - a.margin).slice(0, MOST_ROWS);
  const widest = Math.max(
    1.25,
    ...shown
      .flatMap(({ at, holds, fails }) => [at, holds ?? 0, fails ?? 0].map(Math.abs))
      .map((value) => value * 1.1),
  );
  const names = numbered([...new Set(shown.map(({ row }) => row))]);
  for (const row of shown) row.row_key = names.key_of(row.row);
  const x = (field) => ({
    field,
    type: "quantitative",
    scale: { domain: [-widest, widest], nice: false },
    axis: { title: "error ÷ tolerance", grid: false, tickCount: 7 },
  });
  const y = name_axis("row_key", names, { grid: false });
  const tooltip = [
    tip("row", "case"),
    tip("measured", "measured"),
    tip("expected", "expected"),
    tip("verdict", "verdict"),
  ];
  return {
    title: "Thresholds, with the bracket that bisection left",
    caption:
      (rows.length > shown.length ? `The ${MOST_ROWS} worst of ${rows.length}. ` : "") +
      (shown.some(({ holds }) => holds !== null)
        ? "Bar: from the last load that holds to the first that slides. "
        : "") +
      "Shaded: the tolerance.",
    description: `Deviation of ${shown.length} critical values from the expected ones, in tolerances.`,
    spec: {
      height: { step: 22 },
      data: { values: shown },
      layer: [
        {
          data: { values: [{ low: -1, high: 1 }] },
          mark: { type: "rect", color: "$band" },
          encoding: { x: { ...x("low") }, x2: { field: "high" } },
        },
        {
          data: { values: [{ zero: 0 }] },
          mark: { type: "rule", color: "$axis", strokeDash: [3, 3] },
          encoding: { x: x("zero") },
        },
        {
          mark: { type: "bar", height: 9, color: "$axis", opacity: 0.5 },
          encoding: { x: x("holds"), x2: { field: "fails" }, y, tooltip },
        },
        {
          mark: { type: "tick", thickness: 2, size: 13, color: "$muted" },
          encoding: { x: x("holds"), y },
        },
        {
          mark: { type: "tick", thickness: 2, size: 13, color: "$muted" },
          encoding: { x: x("fails"), y },
        },
        {
          mark: { type: "point", filled: true, size: 65, opacity: 1, cursor: "pointer" },
          encoding: {
            x: x("at"),
            y,
            tooltip,
            ...verdict_encoding(null),
          },
        },
      ],
    },
  };
}

/** Measured against expected, with the line on which they are equal; null below three different values. */
export function prediction_plot(entries) {
  const values = entries
    .flatMap(({ label, record }) =>
      record.checks.filter(is_threshold).map((check) => ({
        row: label,
        case: record.case,
        x: rounded(to_number(check.expected)),
        y: rounded(to_number(check.value)),
        verdict: check.verdict,
        quantity: check.quantity,
        unit: check.unit,
      })),
    )
    .filter(({ x, y }) => x !== null && y !== null);
  if (
    new Set(values.map(({ x }) => x)).size < 3 ||
    new Set(values.map(({ unit }) => unit)).size > 1
  )
    return null;
  const limits = values.flatMap(({ x, y }) => [x, y]);
  const [low, high] = [
    limits.reduce((a, b) => Math.min(a, b), 0),
    limits.reduce((a, b) => Math.max(a, b), 0) * 1.08,
  ];
  const axis = (field, title) => ({
    field,
    type: "quantitative",
    scale: { domain: [low, high], nice: false },
    axis: { title, tickCount: 6 },
  });
  const { quantity } = values[0];
  return {
    title: "Measured against expected",
    caption: "On the line they are equal.",
    description: `${values.length} measured values of ${quantity} against the expected ones.`,
    spec: {
      height: 260,
      layer: [
        {
          data: {
            values: [
              { x: low, y: low },
              { x: high, y: high },
            ],
          },
          mark: { type: "line", color: "$axis", strokeWidth: 1 },
          encoding: { x: axis("x", `expected ${quantity}`), y: axis("y", `measured ${quantity}`) },
        },
        {
          data: { values: values.slice(0, 2000) },
          mark: { type: "point", size: 60, strokeWidth: 2, opacity: 0.9, cursor: "pointer" },
          encoding: {
            x: axis("x", `expected ${quantity}`),
            y: axis("y", `measured ${quantity}`),
            ...verdict_encoding(null),
            tooltip: [tip("row", "case"), tip_number("x", "expected"), tip_number("y", "measured")],
          },
        },
      ],
    },
  };
}
