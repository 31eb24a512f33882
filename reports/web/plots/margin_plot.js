// SPDX-License-Identifier: GPL-3.0-or-later
// The overview: how close each check stands to its tolerance, a row a family.
import { group_by } from "../model/family.js";
import { margin } from "../model/check_text.js";
import { row_height } from "../model/overview.js";
import { name_axis, numbered, tip, tip_number } from "./names.js";
import { VERDICT_DOMAIN, VERDICT_LABELS, verdict_encoding } from "./palette.js";

const LOWEST = -9; // decades; an exact result stands here
const HIGHEST = 6;
const PER_DECADE = 4;

function place_of(value) {
  if (value === 0) return LOWEST;
  const decades = Math.log10(value);
  return Math.min(
    HIGHEST,
    Math.max(LOWEST + 1 / PER_DECADE, Math.round(decades * PER_DECADE) / PER_DECADE),
  );
}

/** `families`: [{name, records}] in the order of the rows. */
export function margin_plot(families) {
  const rows = numbered(families.map(({ name }) => name));
  const values = families.flatMap(({ name, records }) => {
    const checks = records
      .flatMap((record) => record.checks)
      .filter(({ verdict }) => verdict !== "not-applicable");
    const bins = group_by(checks, (check) => `${place_of(margin(check))} ${check.verdict}`);
    return [...bins.values()].map((bin) => ({
      family: name,
      family_key: rows.key_of(name),
      place: place_of(margin(bin[0])),
      verdict: bin[0].verdict,
      checks: bin.length,
    }));
  });
  if (values.length === 0) return null;
  const highest = Math.max(1, ...values.map(({ place }) => Math.ceil(place)));
  const x = {
    field: "place",
    type: "quantitative",
    scale: { domain: [LOWEST, highest], nice: false, padding: 10 },
    axis: {
      title: "|error| ÷ tolerance",
      orient: "bottom",
      values: [LOWEST, -8, -6, -4, -2, 0, 2, 4, 6].filter((value) => value <= highest),
      labelExpr: `datum.value == ${LOWEST} ? 'exact' : datum.value == 0 ? 'limit' : '1e' + datum.value`,
      labelOverlap: true,
    },
  };
  const present = VERDICT_DOMAIN.filter((verdict) =>
    values.some((value) => value.verdict === verdict),
  );
  const legend =
    present.length > 1 ? { values: present, labelExpr: VERDICT_LABELS, columns: 4 } : null;
  return {
    title: "How close each check stands to its tolerance",
    caption: "A check holds left of the limit. Larger marks are several checks.",
    description: `|error| ÷ tolerance of ${values.reduce((sum, { checks }) => sum + checks, 0)} checks, by family.`,
    spec: {
      height: { step: row_height(families.length) },
      layer: [
        {
          data: { values: [{ low: 0, high: highest }] },
          mark: { type: "rect", color: "$fail", opacity: 0.07 },
          encoding: { x: { ...x, field: "low" }, x2: { field: "high" } },
        },
        {
          data: { values: [{ place: 0 }] },
          mark: { type: "rule", color: "$ink", strokeWidth: 1.25 },
          encoding: { x },
        },
        {
          data: { values },
          mark: { type: "point", filled: true, opacity: 0.85, cursor: "pointer" },
          encoding: {
            x,
            y: name_axis("family_key", rows, { grid: true }),
            size: {
              field: "checks",
              type: "quantitative",
              scale: {
                type: "sqrt",
                domain: [1, Math.max(16, ...values.map(({ checks }) => checks))],
                range: [42, 260],
              },
              legend: null,
            },
            ...verdict_encoding(legend),
            tooltip: [
              tip("family", "family"),
              tip("verdict", "verdict"),
              tip_number("checks", "checks"),
            ],
          },
        },
      ],
    },
  };
}
