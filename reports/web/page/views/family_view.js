// SPDX-License-Identifier: GPL-3.0-or-later
// One family: its plots over all cases, and its cases.
import { h, replace } from "../dom.js";
import { glyph, verdict_mark } from "../widgets/glyph.js";
import { style_mark } from "../widgets/style_mark.js";
import { machine_mark, machines_note } from "../widgets/machine_mark.js";
import { margin_bar } from "../widgets/margin_bar.js";
import { plot_figure } from "../widgets/plot_figure.js";
import { plots_of_family } from "../records.js";
import { case_hash, hash_of } from "../route.js";
import { group_by, short_name } from "../../model/family.js";
import { joined_letters } from "../../model/machine.js";
import { format_seconds } from "../../model/number.js";
import { ordered_configurations } from "../../model/configuration.js";
import { rank, VERDICT_WORDS } from "../../model/verdict.js";

const MOST_CASES = 200;

// The worst verdict of each configuration that ran a case.
const by_configuration = (rows) =>
  ordered_configurations(rows.map((row) => row.column)).map((name) => {
    const own = rows.filter((row) => row.column === name);
    const { verdict } = own.reduce((a, b) => (rank(b.verdict) < rank(a.verdict) ? b : a));
    return h(
      "span",
      { class: "of-configuration", title: `${name}: ${VERDICT_WORDS[verdict] ?? verdict}` },
      style_mark(name, 9),
      " ",
      glyph(verdict, 13),
      h("span", { class: "sr" }, `${name} ${VERDICT_WORDS[verdict] ?? verdict}; `),
    );
  });

export async function show_family(element, name, { index, rows }) {
  const current = rows.filter((row) => row.family === name && index.runs[row.run].role === "shown");
  if (current.length === 0) {
    replace(
      element,
      h("h1", {}, "There is no such family"),
      h("p", {}, h("a", { href: hash_of("cases") }, "All cases")),
    );
    return;
  }
  const cases = [...group_by(current, (row) => row.case)];
  const line = ([case_name, list]) => {
    const worst = list.reduce((a, b) => (rank(b.verdict) < rank(a.verdict) ? b : a));
    const closest = list.reduce((most, row) => Math.max(most, row.check?.margin ?? 0), 0);
    return h(
      "tr",
      {},
      h("td", {}, verdict_mark(worst.verdict, 15)),
      h(
        "th",
        { scope: "row" },
        h("a", { href: case_hash(case_name) }, short_name(case_name)),
        h("span", { class: "variant" }, list[0].title),
      ),
      h("td", {}, margin_bar(closest, true, worst.check?.verdict)),
      h("td", {}, by_configuration(list)),
      h("td", { class: "number" }, String(list.length)),
      h(
        "td",
        { class: "number" },
        format_seconds(list.reduce((sum, row) => sum + row.seconds, 0)),
        machine_mark(joined_letters(list.map((row) => row.machine))),
      ),
    );
  };
  const plots = await plots_of_family(name, index);
  replace(
    element,
    h(
      "p",
      { class: "crumbs" },
      h("a", { href: hash_of("summary") }, "Summary"),
      " / ",
      h("a", { href: hash_of("cases", "", { family: name }) }, "its records in the table"),
    ),
    h("h1", {}, name),
    plots.length > 0 &&
      h(
        "div",
        { class: "plot-grid" },
        plots.map((plot) => plot_figure(plot, { heading: "h2" })),
      ),
    h("h2", {}, "Cases"),
    machines_note(current.map((row) => row.machine)),
    h(
      "div",
      { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "Cases of the family" },
      h(
        "table",
        { class: "family-cases" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            ["Verdict", "Case", "Worst check", "Configurations", "Records", "CPU s"].map(
              (text, i) => h("th", { scope: "col", class: i > 3 ? "number" : "" }, text),
            ),
          ),
        ),
        h("tbody", {}, cases.slice(0, MOST_CASES).map(line)),
      ),
    ),
    cases.length > MOST_CASES &&
      h(
        "p",
        {},
        h("a", { href: hash_of("cases", "", { family: name }) }, `All ${cases.length} cases`),
      ),
  );
}
