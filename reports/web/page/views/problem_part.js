// SPDX-License-Identifier: GPL-3.0-or-later
// What a case's problem is: a drawing from its geometry and its data, as a verification manual has them.
import { problem_of } from "../../model/problem.js";
import { body_rows, problem_facts } from "../../model/problem_text.js";
import { problem_sketch } from "../../sketch/sketch.js";
import { from_tree, h } from "../dom.js";

const COLUMNS = [
  ["name", "Body", ""],
  ["shape", "Shape", ""],
  ["mass", "Mass", "kg"],
  ["density", "Density", "kg/m³"],
  ["youngs_modulus", "E", ""],
  ["poisson_ratio", "ν", ""],
  ["damping", "Damping", ""],
];
const WORDS = 2; // as many columns hold words

function bodies_table(problem) {
  const rows = body_rows(problem);
  const shown = COLUMNS.filter(([field]) => rows.some((row) => row[field] !== "–"));
  return h(
    "div",
    { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "Bodies" },
    h(
      "table",
      { class: "bodies" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          shown.map(([, name, unit], i) =>
            h(
              "th",
              { scope: "col", class: i < WORDS ? "" : "number" },
              name,
              unit && h("span", { class: "unit" }, ` ${unit}`),
            ),
          ),
        ),
      ),
      h(
        "tbody",
        {},
        rows.map((row) =>
          h(
            "tr",
            {},
            shown.map(([field], i) =>
              i === 0
                ? h("th", { scope: "row" }, row[field])
                : h("td", { class: i < WORDS ? "" : "number" }, row[field]),
            ),
          ),
        ),
      ),
    ),
  );
}

/** The figure of a problem; `surfaces` as problem_sketch() takes them. */
function sketch_figure(problem, title, surfaces) {
  const { drawing, caption, key } = problem_sketch(problem, { surfaces, title });
  return h(
    "figure",
    { class: "scene" },
    from_tree(drawing),
    h(
      "figcaption",
      {},
      caption,
      key.map(([name, word], i) => [
        i > 0 ? ", " : " ",
        h("span", { class: `key key-${name}` }, word),
      ]),
      key.length > 0 && ".",
    ),
  );
}

/** Null where no record of the case tells its problem. */
export function problem_part(records, surfaces_of = () => new Map()) {
  const record = records.find((one) => problem_of(one) !== null);
  if (!record) return null;
  const problem = problem_of(record);
  return h(
    "section",
    { class: "problem", "aria-labelledby": "problem-title" },
    h("h2", { id: "problem-title" }, "The problem"),
    sketch_figure(problem, record.case, surfaces_of(problem)),
    bodies_table(problem),
    h(
      "dl",
      { class: "why problem-facts" },
      problem_facts(problem, record).map(({ name, lines }) => [
        h("dt", {}, name),
        h(
          "dd",
          {},
          lines.map((text) => h("div", {}, text)),
        ),
      ]),
    ),
  );
}

/** About how tall that is in half a page's width, px. */
export function problem_height(records) {
  const record = records.find((one) => problem_of(one) !== null);
  if (!record) return 0;
  const problem = problem_of(record);
  const lines = problem_facts(problem, record).flatMap((fact) => fact.lines);
  return (
    430 +
    32 * body_rows(problem).length +
    lines.reduce((sum, text) => sum + 22 * Math.ceil(text.length / 70), 0)
  );
}
