// SPDX-License-Identifier: GPL-3.0-or-later
// How many digits survive what must not matter, and how far each ladder holds.
import { json_of } from "../asset.js";
import { h, replace } from "../dom.js";
import { plots_of_family } from "../records.js";
import { hash_of } from "../route.js";
import { style_mark } from "../widgets/style_mark.js";
import { term } from "../widgets/term.js";
import { digits_table } from "./digits_table.js";
import { ladder_section, ladders_table } from "./ladders_part.js";
import { stability_sentences } from "./stability_words.js";

// One table at a time; on paper they all stand.
function tables_part({ groups, tables }, chosen_name, place) {
  if (tables.length === 0) return null;
  const chosen = tables.find(({ name }) => name === chosen_name) ?? tables[0];
  const several = tables.length > 1;
  return h(
    "section",
    { "aria-labelledby": "digits-title" },
    h("h2", { id: "digits-title" }, term("digits that survive", "Digits that survive")),
    h(
      "p",
      { class: "message" },
      "Each column is a ",
      term("perturbation"),
      " of a whole scene that must not change what is measured. “exact”: every bit is the same; “–”: no digit survives; “n/a”: the scene has nothing to perturb so.",
    ),
    several &&
      h(
        "nav",
        { class: "tabs", "aria-label": "Configurations" },
        tables.map((table) =>
          h(
            "a",
            {
              href: hash_of("stability", place, { of: table.name }),
              "aria-current": table === chosen ? "true" : null,
            },
            style_mark(table.configuration),
            ` ${table.name}`,
          ),
        ),
      ),
    tables.map((table) =>
      h(
        "div",
        { class: table === chosen ? "of-one" : "of-one unchosen" },
        h("h3", { class: several ? "table-name" : "sr" }, table.name),
        digits_table(table.name, groups, table.rows),
      ),
    ),
  );
}

// The plots of all ladders, by their keys.
async function plots_of(ladders, index) {
  const families = [...new Set(ladders.map(({ family }) => family))];
  const all = await Promise.all(families.map((family) => plots_of_family(family, index)));
  return new Map(all.flat().map((plot) => [plot.ladder, plot]));
}

/** `place` is the ladder that was asked for; `of` the configuration whose table is. */
export async function show_stability(element, place, { index }, list, { of = "" } = {}) {
  const told = await json_of("stability");
  const plots = await plots_of(told.ladders, index);
  const sentence = stability_sentences(index.stability).join("; ");
  replace(
    element,
    h("h1", {}, "Stability"),
    sentence && h("p", { class: "subline" }, `${sentence[0].toUpperCase()}${sentence.slice(1)}.`),
    tables_part(told, of, place),
    told.ladders.length > 0 && [
      h("h2", {}, "Where it breaks"),
      h(
        "p",
        { class: "message" },
        "Each ",
        term("ladder"),
        " sweeps one parameter. A span holds without a break around the rung nearest to 1 that holds; the first on either side that does not is named.",
      ),
      ladders_table(told),
      told.ladders.map((ladder) =>
        ladder_section(ladder, plots.get(ladder.key), ladder.key === place),
      ),
    ],
  );
  if (place)
    setTimeout(() => element.querySelector(".ladder.chosen")?.scrollIntoView({ block: "start" }));
}
