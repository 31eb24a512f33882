// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison's answer first: who wins each scene, question by question, and by how much.
import { figure_text } from "../../model/figure.js";
import { name_with_unit, with_unit } from "../../model/number.js";
import { breakable, h } from "../dom.js";
import { case_hash } from "../route.js";

const MOST_OPEN = 12; // scenes that are not folded

const value_of = ({ value }, unit) => with_unit(figure_text(value), unit);

function answer_cell(answer) {
  if (!answer) return h("td", {}, h("span", { class: "none" }, "·"));
  const { winner, ties, second, unit, asked } = answer;
  if (!winner) return h("td", {}, h("span", { class: "none" }, `none of ${asked} gets there`));
  return h(
    "td",
    {},
    h("strong", {}, winner.label),
    " ",
    h("span", { class: "who-value" }, value_of(winner, unit)),
    h(
      "span",
      { class: "cell-note" },
      ties > 0 ? `and ${ties} more just as good${second ? "; then " : ""}` : second ? "then " : "",
      second ? `${second.label} ${value_of(second, unit)}` : "",
      !second && ties === 0 && "the only one",
    ),
  );
}

const scene_row = ({ case: name, title, answers }) =>
  h(
    "tr",
    {},
    h("th", { scope: "row" }, h("a", { href: case_hash(name), title }, breakable(name))),
    answers.map(answer_cell),
  );

const wins_text = ({ wins, scenes }) =>
  wins.length === 0
    ? "none gets there"
    : `${wins[0].label}: first in ${wins[0].count} of ${scenes}${wins[1] ? `; ${wins[1].label} in ${wins[1].count}` : ""}`;

const table = (label, heads, rows, extra) =>
  h(
    "div",
    { class: "data-scroll", tabindex: "0", role: "region", "aria-label": label },
    h(
      "table",
      { class: "winners" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("th", { scope: "col" }, "Scene"),
          heads.map((text) => h("th", { scope: "col" }, text)),
        ),
        extra,
      ),
      h("tbody", {}, rows),
    ),
  );

// Scenes to which none of the questions was put: the least of their chief figure.
const others_part = (others) =>
  others.length > 0 &&
  h(
    "details",
    { open: others.length <= MOST_OPEN },
    h(
      "summary",
      {},
      `${others.length} other scene${others.length === 1 ? "" : "s"}, by the least of a figure`,
    ),
    table(
      "Other scenes",
      ["Least", "Of what"],
      others.map((scene) => {
        const [{ quantity, unit }] = scene.answers;
        const row = scene_row(scene);
        row.append(h("td", {}, name_with_unit(quantity, unit)));
        return row;
      }),
    ),
  );

/** `winners` as make/winners.mjs gives them. Null where nothing was asked. */
export function winners_part({ questions, scenes, others }) {
  if (scenes.length === 0 && others.length === 0) return null;
  const rows = scenes.map(scene_row);
  const most_wins = h(
    "tr",
    { class: "wins" },
    h("th", { scope: "row" }, "Over all scenes"),
    questions.map((question) => h("td", {}, wins_text(question))),
  );
  const heads = questions.map(({ words, quantity }) => [
    words,
    h("span", { class: "row-note" }, quantity),
  ]);
  return h(
    "section",
    { class: "winners-part", "aria-labelledby": "winners-title" },
    h("h2", { id: "winners-title" }, "Who wins"),
    scenes.length > 0 && table("Who wins", heads, rows.slice(0, MOST_OPEN), most_wins),
    rows.length > MOST_OPEN &&
      h(
        "details",
        {},
        h("summary", {}, `${rows.length - MOST_OPEN} more scenes`),
        table("More scenes", heads, rows.slice(MOST_OPEN)),
      ),
    others_part(others),
  );
}
