// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a manual's page, as trees: a case's problem, its claims, its results.
import { band_text, margin, short_margin } from "../model/check_text.js";
import {
  causes_of,
  claims_of,
  expected_of,
  is_banded,
  told,
  tolerance_of,
} from "../model/claim.js";
import { configuration_of } from "../model/configuration.js";
import { format_error, format_pair, name_with_unit, to_number } from "../model/number.js";
import { problem_of } from "../model/problem.js";
import { body_rows, problem_facts } from "../model/problem_text.js";
import { VERDICT_WORDS } from "../model/verdict.js";
import { PATHS } from "../page/widgets/glyph.js";
import { SHAPES } from "../page/widgets/style_mark.js";
import { configuration_styles } from "../plots/configuration_style.js";
import { problem_sketch } from "../sketch/sketch.js";
import { e } from "../sketch/tree.js";

const mark = (name, box, path) =>
  e(
    "svg",
    { class: `mark ${name}`, viewBox: box, "aria-hidden": "true" },
    e("path", { d: path, fill: "currentColor", "fill-rule": "evenodd" }),
  );

/** Shape and word. */
export function verdict_mark(verdict) {
  const known = verdict in PATHS ? verdict : "not-applicable";
  return e(
    "span",
    { class: `verdict verdict-${known}` },
    mark("glyph", "0 0 16 16", PATHS[known]),
    " ",
    VERDICT_WORDS[verdict] ?? verdict,
  );
}

export function configuration_mark(name, label = name) {
  const { colour, shape } = configuration_styles([name]).get(name);
  const path = SHAPES[shape] ?? SHAPES.circle;
  return [mark(`series-${colour.slice(1)}`, "-1.3 -1.3 2.6 2.6", path), " ", label];
}

/** A table of `columns` [[name, is a number]] and bodies of rows. */
export const table = (columns, ...bodies) =>
  e(
    "div",
    {
      class: "scroll",
      tabindex: "0",
      role: "region",
      "aria-label": `Table: ${columns.map(([name]) => name).join(", ")}`,
    },
    e(
      "table",
      {},
      e(
        "thead",
        {},
        e(
          "tr",
          {},
          columns.map(([name, number]) =>
            e("th", { scope: "col", class: number && "number" }, name),
          ),
        ),
      ),
      bodies.map((rows) => e("tbody", {}, rows)),
    ),
  );

export const row = (cells, columns) =>
  e(
    "tr",
    {},
    cells.map((cell, i) => e("td", { class: columns[i][1] && "number" }, cell)),
  );

export const facts = (list, name) =>
  e(
    "dl",
    { class: name },
    list.map(([term, ...texts]) => [
      e("dt", {}, term),
      e("dd", {}, texts.length > 1 ? texts.map((text) => e("div", {}, text)) : texts),
    ]),
  );

const BODY_COLUMNS = [
  ["Body"],
  ["Shape"],
  ["Mass, kg", true],
  ["Density, kg/m³", true],
  ["E", true],
  ["ν", true],
  ["Damping", true],
];

function bodies_table(bodies) {
  const cells = bodies.map((body) => Object.values(body));
  const shown = BODY_COLUMNS.map((_, i) => i).filter((i) =>
    cells.some((row_of) => row_of[i] !== "–"),
  );
  const columns = shown.map((i) => BODY_COLUMNS[i]);
  return table(
    columns,
    cells.map((all) =>
      row(
        shown.map((i) => all[i]),
        columns,
      ),
    ),
  );
}

/** The drawing and the data of a record's problem; one sentence where it tells none. */
export function problem_part(record, surfaces_of) {
  const problem = problem_of(record);
  if (!problem)
    return e(
      "p",
      { class: "of" },
      "The record does not tell the problem: nothing was simulated, or an older program wrote it.",
    );
  const { drawing, caption } = problem_sketch(problem, {
    surfaces: surfaces_of(problem),
    title: record.case,
  });
  return [
    e(
      "div",
      { class: "problem" },
      e("figure", { class: "scene" }, drawing, e("figcaption", {}, caption)),
      facts(problem_facts(problem, record).map(({ name, lines }) => [name, ...lines])),
    ),
    bodies_table(body_rows(problem)),
  ];
}

const reasoned = ({ value, why }) => (value ? `${value}: ${why}` : why);

function claim_part(group) {
  const [{ check }] = group;
  const { causes, bands } = causes_of(group);
  const places = told(group, "worst");
  return e(
    "div",
    { class: "claim" },
    e("p", {}, e("strong", {}, check.quantity), ": ", check.claim),
    check.formula && e("p", { class: "formula" }, check.formula),
    facts(
      [
        ["Expected", reasoned(expected_of(group))],
        ["Tolerance", reasoned(tolerance_of(group))],
        causes.length > 0 && ["Cause of the shortfall", ...causes],
        bands.length > 0 && ["Band", ...bands],
        places !== "" && ["Worst place", places],
      ].filter(Boolean),
    ),
  );
}

function result_row({ check, name }, columns, banded) {
  const [value, expected] = format_pair(to_number(check.value), to_number(check.expected));
  const relative = check.relative ? " rel" : "";
  const cells = [
    name,
    value,
    expected,
    `${format_error(to_number(check.error))}${relative}`,
    `${format_error(to_number(check.tolerance))}${relative}`,
    short_margin(margin(check)),
    verdict_mark(check.verdict),
    ...(banded ? [band_text(check)] : []),
  ];
  return row(cells, columns);
}

function results_part(claims) {
  const banded = claims.some(is_banded);
  const columns = [
    ["Configuration"],
    ["Measured", true],
    ["Expected", true],
    ["Error", true],
    ["Tolerance", true],
    ["|Error| ÷ tolerance", true],
    ["Verdict"],
    ...(banded ? [["Band"]] : []),
  ];
  return table(
    columns,
    ...claims.map((group) => [
      e(
        "tr",
        {},
        e(
          "th",
          { scope: "rowgroup", colspan: columns.length },
          name_with_unit(group[0].check.quantity, group[0].check.unit),
        ),
      ),
      ...group.map((entry) => result_row(entry, columns, banded)),
    ]),
  );
}

/** `entries`: [{record, name}], `name` a tree for the first column. Claims, then what came out. */
export function claims_and_results(entries) {
  const claims = claims_of(entries);
  if (claims.length === 0) return e("p", {}, "Nothing was checked.");
  return [
    e("h3", {}, "What is claimed"),
    claims.map(claim_part),
    e("h3", {}, "Results"),
    results_part(claims),
  ];
}

/** A record's configuration, led by what tells its case apart in a group of cases. */
export const entry_name = (record, label, case_label) => [
  case_label && `${case_label}: `,
  configuration_mark(configuration_of(record), label || configuration_of(record)),
];
