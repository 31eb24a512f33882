// SPDX-License-Identifier: GPL-3.0-or-later
// Who holds what: a column a configuration, what it comes to first, then a row a family. Families in which
// something fails or falls short come first; those in which all hold are folded into one row.
import { short_margin } from "../../model/check_text.js";
import { format_count, format_seconds_short, general, to_number } from "../../model/number.js";
import { is_bad, VERDICT_WORDS } from "../../model/verdict.js";
import { h } from "../dom.js";
import { glyph } from "../widgets/glyph.js";
import { machine_mark } from "../widgets/machine_mark.js";
import { style_mark } from "../widgets/style_mark.js";
import { term } from "../widgets/term.js";
import { case_hash, hash_of } from "../route.js";

const MOST_OPEN = 14; // families that are not folded

const plural = (count, word) => `${format_count(count)} ${word}${count === 1 ? "" : "s"}`;

const DECIDED = ["error", "fail", "expected-shortfall", "refuted", "pass"];
const count_of = ({ counts }, verdict) => counts.find(([name]) => name === verdict)?.[1] ?? 0;
const decided_of = (cell) => DECIDED.reduce((sum, verdict) => sum + count_of(cell, verdict), 0);
const ratio_of = (cell) => (cell.worst ? to_number(cell.worst.margin) : 0);

/** "97 %", "≥ 1e6 ×": beyond that no digit says more. */
export function ratio_text(ratio) {
  return ratio >= 1e6 ? "≥ 1e6 ×" : short_margin(ratio);
}

const said = (cell) =>
  cell.counts.map(([verdict, count]) => `${count} ${VERDICT_WORDS[verdict]}`).join(", ");

function link_of(cell, family, column) {
  if (cell.case) return case_hash(cell.case);
  return hash_of("cases", "", { family, configuration: column });
}

function cell_link(cell, family, column) {
  const worst = cell.worst;
  const shown = worst && ratio_of(cell) > 0;
  return h(
    "a",
    {
      href: link_of(cell, family, column),
      title: `${family ? `${family}, ` : ""}${column}: ${said(cell)}${worst ? `; worst: ${worst.quantity} in ${worst.case}` : ""}`,
    },
    h(
      "span",
      { class: "cell-counts" },
      cell.counts.map(([verdict, count]) =>
        h(
          "span",
          { class: `verdict-${verdict}` },
          glyph(verdict, 12),
          h("span", { class: "sr" }, `${VERDICT_WORDS[verdict]} `),
          format_count(count),
        ),
      ),
    ),
    " ",
    h("span", { class: "cell-ratio" }, shown ? ratio_text(ratio_of(cell)) : ""),
  );
}

const family_row = ({ name, cells }, columns) =>
  h(
    "tr",
    {
      class: cells.some((cell) => cell?.counts.some(([verdict]) => is_bad(verdict))) ? "bad" : "",
    },
    h("th", { scope: "row" }, h("a", { href: hash_of("family", name) }, name)),
    cells.map((cell, i) =>
      h(
        "td",
        {},
        cell ? cell_link(cell, name, columns[i].name) : h("span", { class: "none" }, "·"),
      ),
    ),
  );

// The columns' totals over some families: counts and the worst ratio.
function summed(families, place) {
  const cells = families.map(({ cells: list }) => list[place]).filter(Boolean);
  if (cells.length === 0) return null;
  const counts = new Map();
  for (const { counts: own } of cells)
    for (const [verdict, count] of own) counts.set(verdict, (counts.get(verdict) ?? 0) + count);
  const worst = cells.reduce((a, b) => (ratio_of(b) > ratio_of(a) ? b : a)).worst;
  return { counts: [...counts], worst };
}

// Rows of families behind a button; on paper they all stand.
function folded_part(families, columns, words) {
  const body = h(
    "tbody",
    { class: "folded", id: "matrix-folded" },
    families.map((one) => family_row(one, columns)),
  );
  const button = h(
    "button",
    {
      type: "button",
      class: "fold",
      "aria-expanded": "false",
      "aria-controls": "matrix-folded",
      onclick: () => {
        const open = body.classList.toggle("open");
        button.setAttribute("aria-expanded", String(open));
      },
    },
    words,
  );
  const total = columns.map((_, i) => summed(families, i));
  return [
    h(
      "tbody",
      {},
      h(
        "tr",
        { class: "fold-row" },
        h("th", { scope: "row" }, button),
        total.map((cell) =>
          h(
            "td",
            {},
            cell
              ? [
                  h(
                    "span",
                    { class: "cell-counts" },
                    cell.counts.map(([verdict, count]) =>
                      h(
                        "span",
                        { class: `verdict-${verdict}` },
                        glyph(verdict, 12),
                        h("span", { class: "sr" }, `${VERDICT_WORDS[verdict]} `),
                        format_count(count),
                      ),
                    ),
                  ),
                  " ",
                  h(
                    "span",
                    { class: "cell-ratio" },
                    ratio_of(cell) > 0 ? ratio_text(ratio_of(cell)) : "",
                  ),
                ]
              : h("span", { class: "none" }, "·"),
          ),
        ),
      ),
    ),
    body,
  ];
}

const speed = (value) => (value === 0 ? "0 m/s" : `${general(value, 1)} m/s`);

// "creeps in 12 of 14", with how fast.
function creep_cell({ creep }) {
  if (creep.looked === 0) return h("span", { class: "none" }, "·");
  const { looked, creeping, fastest } = creep;
  const text = creeping > 0 ? `yes, ${creeping} of ${looked}` : `no, 0 of ${looked}`;
  return [
    h("span", { class: creeping > 0 ? "creeps" : "rests" }, text),
    fastest &&
      h("a", { class: "cell-note", href: case_hash(fastest.case) }, `≤ ${speed(fastest.value)}`),
  ];
}

function holds_cell(column) {
  const decided = decided_of(column);
  const held = count_of(column, "pass");
  const info = count_of(column, "for-information");
  return [
    h(
      "a",
      {
        class: held === decided && decided > 0 ? "all-hold" : "some-hold",
        href: hash_of("cases", "", { configuration: column.name }),
      },
      decided > 0 ? `${format_count(held)} of ${format_count(decided)}` : "not judged",
    ),
    info > 0 && h("span", { class: "cell-note" }, `+ ${format_count(info)} not judged`),
  ];
}

function worst_cell(column) {
  if (!column.worst) return h("span", { class: "none" }, "·");
  const nearest = to_number(column.nearest);
  return [
    h(
      "a",
      {
        href: case_hash(column.worst.case),
        title: `${column.worst.quantity} in ${column.worst.case}`,
      },
      ratio_text(ratio_of(column)),
    ),
    ratio_of(column) > 1 &&
      nearest > 0 &&
      h("span", { class: "cell-note" }, `${ratio_text(nearest)} where it holds`),
  ];
}

// The same cases for each: only so counts compare.
function shared_cell({ shared }) {
  if (!shared) return h("span", { class: "none" }, "·");
  const held = count_of(shared, "pass");
  const decided = decided_of(shared);
  const info = count_of(shared, "for-information");
  return [
    h("span", { class: held === decided ? "all-hold" : "some-hold" }, `${held} of ${decided}`),
    info > 0 && h("span", { class: "cell-note" }, `+ ${info} not judged`),
  ];
}

const cost_cell = (column) => [
  `${format_seconds_short(to_number(column.seconds))} s`,
  machine_mark(column.machines),
  column.broke > 0 && h("span", { class: "cell-note" }, `${column.broke} broke off early`),
];

function totals(columns, shared) {
  const row = (name, words, cell) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, name, words && h("span", { class: "row-note" }, words)),
      columns.map((column) => h("td", {}, cell(column))),
    );
  return h(
    "tbody",
    { class: "totals" },
    row(term("holds", "Holds"), "", holds_cell),
    shared.cases > 0 &&
      row(
        `Holds, of ${plural(shared.cases, "case")} that ${shared.configurations === columns.length ? "all" : shared.configurations} ran`,
        "",
        shared_cell,
      ),
    columns.some(({ creep }) => creep.looked > 0) &&
      row(term("creep", "Creeps at rest"), "", creep_cell),
    row(term("of tolerance", "Worst error ÷ tolerance"), "", worst_cell),
    row(term("CPU time", "CPU time"), "", cost_cell),
  );
}

/** `summary` as make/summary.mjs gives it. */
export function matrix({ configurations, families, shared }) {
  const open = families.filter(({ all_hold }) => !all_hold).slice(0, MOST_OPEN);
  const folded = families.filter((one) => !open.includes(one));
  const all_hold = folded.every((one) => one.all_hold);
  const words = `${folded.length} ${open.length > 0 ? "other " : ""}famil${folded.length === 1 ? "y" : "ies"}${all_hold ? ": all hold" : ""}`;
  return h(
    "div",
    { class: "answer-scroll", tabindex: "0", role: "region", "aria-label": "Who holds what" },
    h(
      "table",
      { class: "answer" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("th", { scope: "col" }, h("span", { class: "sr" }, "Family")),
          configurations.map(({ name }) =>
            h("th", { scope: "col" }, style_mark(name), " ", term(name)),
          ),
        ),
      ),
      totals(configurations, shared),
      open.length > 0 &&
        h(
          "tbody",
          {},
          open.map((one) => family_row(one, configurations)),
        ),
      folded.length > 0 && folded_part(folded, configurations, words),
    ),
  );
}
