// SPDX-License-Identifier: GPL-3.0-or-later
// Perturbed case × perturbation: how many digits survive. Below, what does not hold, each with its command.
import { format_digits, format_error, to_number } from "../../model/number.js";
import { perturbed_of } from "../../model/perturbation.js";
import { VERDICT_WORDS } from "../../model/verdict.js";
import { breakable, h, replace } from "../dom.js";
import { case_hash, hash_of } from "../route.js";
import { command } from "../widgets/command.js";
import { glyph } from "../widgets/glyph.js";
import { with_grid_keys } from "../widgets/grid_keys.js";

/** "14.7", "16", "exact", never more than there are; "–" where none survives or nobody knows. */
export function digits_text({ value, digits }) {
  if (to_number(value) === 0) return "exact";
  const count = to_number(digits);
  if (!(count > 0)) return "–";
  return count >= 16 ? "16" : format_digits(Math.floor(10 * count) / 10);
}

function digits_words(cell) {
  const text = digits_text(cell);
  return text === "exact" ? text : text === "–" ? "no digit" : `${text} digits`;
}

function title_of(group, cell) {
  const scatter = `σ/scale ${format_error(to_number(cell.value))}, allowed ${format_error(to_number(cell.tolerance))}`;
  const words = `${group.name}: ${VERDICT_WORDS[cell.verdict] ?? cell.verdict}, ${digits_words(cell)}; ${scatter}`;
  return cell.worst ? `${words}. Worst: ${cell.worst}` : words;
}

// A number stays with its unit.
const unbroken = (name) => name.replace(/(\d) (?=\S{1,3}$)/, "$1\u00a0");

const check_hash = (row, group) => hash_of("case", row.case, { check: group.name });

function cell_element(row, group, cell) {
  if (!cell) return h("td", { class: "none" }, h("span", { class: "sr" }, "not checked"));
  if (cell.lacking !== undefined)
    return h("td", { class: "lacks", title: `not applicable: ${cell.lacking}` }, "n/a");
  return h(
    "td",
    { class: cell.verdict === "fail" ? "breaks" : "" },
    h(
      "a",
      {
        href: check_hash(row, group),
        class: `verdict-${cell.verdict}`,
        title: title_of(group, cell),
      },
      glyph(cell.verdict, 11),
      h("span", { class: "sr" }, `${VERDICT_WORDS[cell.verdict] ?? cell.verdict} `),
      h("span", { class: "digits" }, digits_text(cell)),
    ),
  );
}

const row_element = (row, groups) =>
  h(
    "tr",
    {},
    h(
      "th",
      { scope: "row", class: "matrix-name" },
      h("a", { href: case_hash(row.case), title: row.title }, breakable(perturbed_of(row.case))),
    ),
    row.ended
      ? h(
          "td",
          { colspan: groups.length, class: "ended" },
          glyph(row.verdict, 11),
          ` ${VERDICT_WORDS[row.verdict] ?? row.verdict}: ${row.ended}`,
        )
      : groups.map((group, i) => cell_element(row, group, row.cells[i])),
  );

// The fewest digits of each column, of what is decided.
function fewest_row(rows, groups) {
  const fewest = (place) => {
    const cells = rows.map(({ cells: list }) => list[place]).filter((cell) => cell?.verdict);
    const worst = cells.reduce(
      (a, b) => (a && !(to_number(b.value) > to_number(a.value)) ? a : b),
      null,
    );
    return worst ? digits_text(worst) : "·";
  };
  return h(
    "tfoot",
    {},
    h(
      "tr",
      {},
      h("th", { scope: "row", class: "matrix-name" }, "Fewest"),
      groups.map((_, i) => h("td", {}, fewest(i))),
    ),
  );
}

const command_row = ([row, group, cell]) =>
  h(
    "div",
    {},
    h(
      "dt",
      {},
      glyph(cell.verdict, 12),
      " ",
      h("a", { href: check_hash(row, group) }, breakable(perturbed_of(row.case))),
      h("span", { class: "row-note" }, `${group.name}: ${digits_words(cell)}`),
    ),
    h(
      "dd",
      {},
      cell.verdict !== "pass" && cell.worst && h("p", { class: "worst" }, cell.worst),
      command(cell.command, `${row.case}, ${group.name}`),
    ),
  );

// What holds is many, and seldom wanted: made when it is opened.
function folded_commands(points) {
  const list = h("dl", { class: "commands" });
  const details = h(
    "details",
    {
      ontoggle: () => {
        if (details.open && list.children.length === 0) replace(list, points.map(command_row));
      },
    },
    h("summary", {}, `The commands of the ${points.length} other points`),
    list,
  );
  return details;
}

function commands_part(rows, groups) {
  const points = rows
    .flatMap((row) => row.cells.map((cell, i) => [row, groups[i], cell]))
    .filter(([, , cell]) => cell?.command);
  const bad = points.filter(([, , { verdict }]) => verdict !== "pass");
  const rest = points.filter((point) => !bad.includes(point));
  return h(
    "div",
    { class: "points" },
    bad.length > 0 && [
      h("h3", {}, "What does not survive, and how to run just that again"),
      h("dl", { class: "commands" }, bad.map(command_row)),
    ],
    rest.length > 0 && folded_commands(rest),
  );
}

/** One engine's and configuration's table. `groups`, `rows` as make/stability.mjs gives them. */
export function digits_table(name, groups, rows) {
  const table = h(
    "table",
    { class: "matrix digits-table", role: "grid", "aria-label": `Digits that survive, ${name}` },
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        h("th", { scope: "col", class: "matrix-name" }, "Case"),
        groups.map(({ name, claim }) => h("th", { scope: "col", title: claim }, unbroken(name))),
      ),
    ),
    h(
      "tbody",
      {},
      rows.map((row) => row_element(row, groups)),
    ),
    rows.length > 1 && fewest_row(rows, groups),
  );
  return [
    h(
      "div",
      { class: "data-scroll matrix-scroll", role: "region", "aria-label": `Digits, ${name}` },
      with_grid_keys(table),
    ),
    commands_part(rows, groups),
  ];
}
