// SPDX-License-Identifier: GPL-3.0-or-later
// Two runs: cost and digits of each record, after against before.
import { quantity_axis, rounded } from "./axes.js";
import { name_axis, numbered, tip, tip_number } from "./names.js";

const MOST_POINTS = 2000;

const WHERE = ["on the same machine", "on another machine"];

// Ratios of CPU time across machines look different: they tell of these.
const by_machine = (changes) =>
  changes.some(({ across }) => across)
    ? {
        color: {
          field: "across",
          type: "nominal",
          scale: { domain: WHERE, range: ["$s0", "$s1"] },
          legend: { values: WHERE },
        },
      }
    : {};

function strip(changes, field, title, name, neutral, log) {
  const rows = numbered([...new Set(changes.map(({ family }) => family))]);
  const values = changes.slice(0, MOST_POINTS).map(({ across, ...change }) => ({
    ...change,
    family_key: rows.key_of(change.family),
    ...(across !== undefined && { across: WHERE[across ? 1 : 0] }),
  }));
  return {
    kind: "comparison",
    title,
    caption: changes.some(({ across }) => across)
      ? "Timings of different machines don't compare: what ran on another machine this time tells of both."
      : "",
    description: `${title}, ${changes.length} records.`,
    spec: {
      height: { step: 20 },
      layer: [
        {
          data: { values: [{ neutral }] },
          mark: { type: "rule", color: "$ink" },
          encoding: { x: { ...quantity_axis("neutral", name, "1", { log }) } },
        },
        {
          data: { values },
          mark: { type: "tick", thickness: 2, color: "$s0", opacity: 0.7 },
          encoding: {
            x: quantity_axis(field, name, "1", { log }),
            y: name_axis("family_key", rows),
            ...by_machine(changes),
            tooltip: [tip("case", "case"), tip_number(field, name)],
          },
        },
      ],
    },
  };
}

/** `changes` as compare() gives them, each with `case` and `family`. */
export function comparison_plots(changes) {
  const costs = changes
    .filter(({ cost_ratio }) => cost_ratio > 0)
    .map(({ case: name, family, cost_ratio, across }) => ({
      case: name,
      family,
      ratio: rounded(cost_ratio),
      across,
    }));
  const digits = changes
    .filter(({ digits_change }) => Number.isFinite(digits_change) && digits_change !== 0)
    .map(({ case: name, family, digits_change }) => ({
      case: name,
      family,
      change: rounded(digits_change),
    }));
  return [
    ...(costs.length > 0
      ? [strip(costs, "ratio", "CPU time, this run ÷ earlier run", "ratio of CPU time", 1, true)]
      : []),
    ...(digits.length > 0
      ? [
          strip(
            digits,
            "change",
            "Digits gained (right) or lost (left)",
            "change of digits",
            0,
            false,
          ),
        ]
      : []),
  ];
}
