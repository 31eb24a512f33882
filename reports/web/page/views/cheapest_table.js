// SPDX-License-Identifier: GPL-3.0-or-later
// The cheapest way to an error below some bounds: of the other engines, and ours beside it.
import { format_bound, format_value, general } from "../../model/number.js";
import { h } from "../dom.js";
import { hash_of } from "../route.js";
import { machine_mark } from "../widgets/machine_mark.js";

const ms = (way) => (way ? general(1e3 * way.seconds, 3) : "–");

const ratio_words = (ratio) =>
  ratio === null ? "–" : `× ${format_value(Number(ratio.toPrecision(2)))}`;

function way_row({ bounds, theirs, ours, ratio }, question, first) {
  const link = (way) =>
    way ? h("a", { href: hash_of("case", question.case, { of: way.name }) }, way.name) : "none";
  return h(
    "tr",
    {},
    first,
    h("td", { class: "number" }, bounds.map(format_bound).join(", ")),
    h("td", {}, link(theirs)),
    h("td", { class: "number" }, ms(theirs)),
    h("td", {}, link(ours)),
    h("td", { class: "number" }, ms(ours)),
    h("td", { class: "number ratio" }, ratio_words(ratio)),
  );
}

/** Null where no question was asked along the efforts. */
export function cheapest_table({ cheapest, questions }) {
  if (cheapest.length === 0) return null;
  const of = new Map(questions.map((one) => [one.case, one]));
  const heading = (text, number, unit) =>
    h(
      "th",
      { scope: "col", class: number ? "number" : "" },
      text,
      unit && h("span", { class: "unit" }, ` ${unit}`),
    );
  return h(
    "section",
    { "aria-labelledby": "cheapest-title" },
    h("h2", { id: "cheapest-title" }, "Cheapest way to an error below …"),
    h(
      "div",
      { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "Cheapest ways" },
      h(
        "table",
        { class: "cheapest" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            heading("Question"),
            heading("Error below", true),
            heading("Cheapest of the others"),
            heading("CPU", true, "ms"),
            heading("Ours"),
            heading("CPU", true, "ms"),
            heading("Ours ÷ theirs", true),
          ),
        ),
        cheapest.map(({ case: name, machine, ways }) => {
          const question = of.get(name);
          const first = h(
            "th",
            { scope: "rowgroup", rowspan: ways.length },
            h("a", { href: hash_of("case", name), title: question.words }, question.id),
            question.unit && h("span", { class: "unit" }, ` ${question.unit}`),
            machine_mark(machine),
          );
          return h(
            "tbody",
            {},
            ways.map((way, i) => way_row(way, question, i === 0 && first)),
          );
        }),
      ),
    ),
  );
}
