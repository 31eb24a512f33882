// SPDX-License-Identifier: GPL-3.0-or-later
// Engine × question: how far each answer is off, its size as colour too.
import { short_error } from "../../model/engine_answer.js";
import { format_bound, general, to_number } from "../../model/number.js";
import { h } from "../dom.js";
import { hash_of } from "../route.js";
import { machine_mark } from "../widgets/machine_mark.js";
import { with_grid_keys } from "../widgets/grid_keys.js";

const LEVELS = [1e-12, 1e-9, 1e-6, 1e-4, 1e-2, 1]; // |error| below which a colour is paler

const WORDS = { broke: "broke", lacks: "–", never: "never" };

const level_of = (error) => LEVELS.filter((bound) => !(Math.abs(error) < bound)).length;

const question_words = ({ words, unit }) => (unit ? `${words} (${unit})` : words);

function cell_words(row, question, cell) {
  const error = to_number(cell.error);
  const said =
    cell.kind === "told"
      ? `off by ${[general(error, 6), question.unit].filter(Boolean).join(" ")}`
      : `${WORDS[cell.kind]}: ${cell.why}`;
  return `${row.name}, ${question.id}: ${said}`;
}

function cell_of(row, question, cell) {
  if (!cell) return h("td", { class: "none" }, "");
  const error = to_number(cell.error);
  const colour = cell.kind === "told" || cell.kind === "never" ? ` level-${level_of(error)}` : "";
  return h(
    "td",
    { class: cell.kind + colour },
    h(
      "a",
      {
        href: hash_of("case", question.case, { of: row.name }),
        title: cell_words(row, question, cell),
      },
      WORDS[cell.kind] ?? short_error(error, question.unit),
    ),
  );
}

function scale_part() {
  const ends = LEVELS.map(format_bound);
  const step = (words, level) => h("span", { class: `step level-${level}` }, words);
  return h(
    "p",
    { class: "matrix-scale" },
    "|error|, in the unit of its column: ",
    ends.map((end, i) => step(`< ${end}`, i)),
    step(`≥ ${ends.at(-1)}, never`, ends.length),
    " “–”: the engine lacks what it takes; “broke”: it failed. Each cell leads to its question and its command.",
  );
}

/** `engines` as make/engines.mjs makes it. */
export function engine_matrix({ questions, rows, priced }) {
  const heading = (question) =>
    h(
      "th",
      { scope: "col" },
      h(
        "a",
        {
          href: hash_of("case", question.case),
          title: question_words(question),
        },
        question.id.split(/(?<=-)/).flatMap((part, i) => (i > 0 ? [h("wbr"), part] : [part])),
      ),
      question.unit && h("span", { class: "unit" }, question.unit),
    );
  const table = h(
    "table",
    { class: "matrix", role: "grid", "aria-label": "How far each engine's answers are off" },
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        h("th", { scope: "col", class: "matrix-name" }, "Engine · configuration"),
        questions.map(heading),
        h(
          "th",
          {
            scope: "col",
            class: "cpu",
            title: priced
              ? `CPU time of the engine's steps: ${priced}, with its usual effort`
              : "CPU time: no question was asked along the efforts",
          },
          "CPU",
          h("span", { class: "unit" }, "ms"),
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
          h("th", { scope: "row", class: "matrix-name" }, row.name),
          row.cells.map((cell, i) => cell_of(row, questions[i], cell)),
          h(
            "td",
            { class: "cpu" },
            row.seconds === null ? "–" : [general(1e3 * row.seconds, 3), machine_mark(row.machine)],
          ),
        ),
      ),
    ),
  );
  return [
    h(
      "div",
      { class: "data-scroll matrix-scroll", role: "region", "aria-label": "Engines by question" },
      with_grid_keys(table),
    ),
    scale_part(),
  ];
}
