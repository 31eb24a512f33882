// SPDX-License-Identifier: GPL-3.0-or-later
// The summary of a comparison: findings, rules by case, work and precision, and every case in a line.
import { figure_text } from "../../model/figure.js";
import { format_count, format_seconds_short, name_with_unit } from "../../model/number.js";
import { breakable, h } from "../dom.js";
import { findings_parts } from "./findings.js";
import { winners_part } from "./winners_part.js";
import { machine_mark } from "../widgets/machine_mark.js";
import { plot_figure } from "../widgets/plot_figure.js";
import { plots_of_family } from "../records.js";
import { case_hash, hash_of } from "../route.js";

const MOST_OPEN = 12; // rows of a list that is not folded

export const compared_headline = ({ rules, cases, failed }) =>
  `${rules} rules side by side in ${cases.length} cases` +
  (failed > 0 ? `; ${format_count(failed)} runs failed.` : "; none failed.");

// Of a folder its chief figure, on each kind of contacts.
const scores_part = (scores) =>
  scores.map(({ folder, plots }) => {
    const chief = plots.filter(({ quantity }) => quantity === plots[0].quantity);
    const figures = new Set(plots.map(({ quantity }) => quantity)).size;
    return h(
      "section",
      {},
      h("h2", {}, `Rules by case: ${folder}/…`),
      h(
        "div",
        { class: chief.some(({ wide }) => wide) ? "" : "plot-pairs" },
        chief.map((plot) => plot_figure(plot)),
      ),
      figures > 1 &&
        h(
          "p",
          {},
          h(
            "a",
            { href: hash_of("plots", "scores") },
            `The same for ${figures - 1} other figure${figures > 2 ? "s" : ""}`,
          ),
        ),
    );
  });

// Comes when its part of the page has been read.
function work_part(index) {
  const place = h("div");
  const families = index.families.filter(({ plots }) =>
    plots.some(({ kind }) => kind === "work-precision"),
  );
  for (const { name } of families)
    plots_of_family(name, index).then((plots) => {
      const [first] = plots.filter(({ kind }) => kind === "work-precision");
      place.append(
        plot_figure(first, { heading: "h2" }),
        h("p", {}, h("a", { href: hash_of("family", name) }, `${name}, mesh by mesh`)),
      );
    });
  return place;
}

function failed_words({ failed, in_part, records }) {
  if (failed === 0 && in_part > 0) return `✕ ${in_part} of ${records} in part`;
  return failed > 0 ? `✕ ${failed} of ${records}` : `0 of ${records}`;
}

function case_row(line) {
  const told = (one) =>
    one ? [figure_text(one.value), " ", h("span", { class: "who" }, one.label)] : "–";
  return h(
    "tr",
    { class: line.failed === line.records ? "failed" : "" },
    h(
      "th",
      { scope: "row" },
      h("a", { href: case_hash(line.case), title: line.title }, breakable(line.case)),
    ),
    h("td", {}, name_with_unit(line.quantity, line.unit)),
    h("td", {}, told(line.best)),
    h("td", { class: "number" }, line.middle === null ? "–" : figure_text(line.middle)),
    h("td", {}, told(line.worst)),
    h(
      "td",
      { class: line.failed + line.in_part > 0 ? "number failed-count" : "number" },
      failed_words(line),
    ),
    h("td", { class: "number" }, format_seconds_short(line.seconds), machine_mark(line.machines)),
  );
}

function cases_part(cases) {
  const heading = (text, number) => h("th", { scope: "col", class: number ? "number" : "" }, text);
  const table = h(
    "div",
    { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "All cases" },
    h(
      "table",
      { class: "compared all-cases" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          heading("Case"),
          heading("Figure"),
          heading("Least, by"),
          heading("Median", true),
          heading("Most, by"),
          heading("Failed", true),
          heading("CPU s", true),
        ),
      ),
      h("tbody", {}, cases.map(case_row)),
    ),
  );
  return h(
    "details",
    { class: "all-cases-fold", open: cases.length <= MOST_OPEN },
    h("summary", {}, h("h2", {}, `All ${cases.length} cases: least, median and most`)),
    table,
  );
}

// Folders as the findings come to speak of them.
function in_order_of(scores, findings) {
  const notes = findings.flatMap((one) => one.notes).join("\n");
  const place = ({ folder }) => {
    const found = notes.indexOf(`${folder}/`);
    return found < 0 ? Infinity : found;
  };
  return [...scores].sort((a, b) => place(a) - place(b) || 0);
}

export function compared_parts(index, rows) {
  const { chief, others } = findings_parts(index.findings, rows, index.runs);
  return [
    winners_part(index.compared.winners),
    chief,
    scores_part(in_order_of(index.compared.scores, index.findings)),
    work_part(index),
    others,
    cases_part(index.compared.cases),
  ];
}
