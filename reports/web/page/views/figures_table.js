// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison as one table: a row a rule on contacts or an engine, a column a figure, the least of each marked, and
// a bar for how much more the others have. Best first; a heading sorts by its column.
import {
  compared_quantities,
  failure_of,
  figure_of,
  figure_text,
  WORK,
} from "../../model/figure.js";
import { machine_letters } from "../../model/machine.js";
import { h, replace } from "../dom.js";
import { machine_mark } from "../widgets/machine_mark.js";
import { is_engine_case } from "../../model/engine.js";
import { answer_of } from "../../model/engine_answer.js";

// Of these less is not better: they tell where, among how many, or whether.
const NO_AMOUNT = /^(best|contacts|diagonal dominance)\b/;

// An engine without an answer never got there.
function error_of(record) {
  const { kind, error } = answer_of(record);
  return kind === "never" ? Infinity : error;
}

const columns_of = (records) =>
  compared_quantities(records).map(({ quantity, unit, meaning }) => ({
    name: quantity,
    unit: unit === "1" ? "" : unit,
    meaning,
    of: (record) =>
      quantity === "error" && is_engine_case(record.case)
        ? error_of(record)
        : figure_of(record, quantity),
  }));

// An error is the less the smaller it is, whatever its sign.
const size_of = (value, name) => (name === "error" ? Math.abs(value) : value);

// {least, most} of what a column holds, of the variants that did not fail; null when all is the same
// or something is negative, so that there is no least of a magnitude.
function range_of(rows, place, name) {
  if (NO_AMOUNT.test(name)) return null;
  const values = rows
    .filter(({ failure }) => !failure)
    .map(({ values: list }) => size_of(list[place], name))
    .filter(Number.isFinite);
  const least = values.reduce((a, b) => Math.min(a, b), Infinity);
  const positive = values.filter((value) => value > 0).reduce((a, b) => Math.min(a, b), Infinity);
  const most = values.reduce((a, b) => Math.max(a, b), -Infinity);
  return values.length > 0 && least >= 0 && most > least ? { least, positive, most } : null;
}

// On a logarithmic scale from the least above 0 to the largest, or to ten times the least where that is
// less; never so short that it is not seen.
function bar_part(value, { positive, most }) {
  if (value <= 0) return 0;
  return 0.06 + 0.94 * (Math.log(value / positive) / Math.log(Math.max(10, most / positive)));
}

function cell(value, size, range, failed) {
  const text = figure_text(value);
  const best = range !== null && !failed && size === range.least;
  const bar = range !== null && Number.isFinite(value) && !failed;
  return h(
    "td",
    {
      class: ["number", best && "best", !Number.isFinite(value) && "never", bar && "with-bar"]
        .filter(Boolean)
        .join(" "),
      style: bar ? { "--part": `${(100 * bar_part(size, range)).toFixed(1)}%` } : {},
    },
    best
      ? [h("span", { class: "best-mark", "aria-hidden": "true" }, "◆ "), h("strong", {}, text)]
      : text,
    best && h("span", { class: "sr" }, " least of its column"),
  );
}

// What failed comes last; what was not measured after what was never reached.
function ordered(rows, place, places) {
  const kind = (value) => (Number.isNaN(value) ? 2 : Number.isFinite(value) ? 0 : 1);
  const by = [place, ...places.filter((other) => other !== place)];
  return [...rows].sort((a, b) => {
    if (!a.failure !== !b.failure) return a.failure ? 1 : -1;
    for (const column of by) {
      const [left, right] = [a.sizes[column], b.sizes[column]];
      if (kind(left) !== kind(right)) return kind(left) - kind(right);
      if (kind(left) === 0 && left !== right) return left - right;
    }
    return 0;
  });
}

/**
 * `entries`: [{record, variant}], variants as compared_variants() gives them; `chosen` is the label of
 * the one that was asked for.
 */
export function figures_table(entries, { heading = "Rule", chosen = "" } = {}) {
  const columns = columns_of(entries.map(({ record }) => record));
  const with_contacts = entries.some(({ variant }) => variant.contacts !== "");
  const with_work = columns.some(({ name }) => name === WORK);
  const letters = with_work ? machine_letters(entries.map(({ record }) => record)) : () => "";
  const rows = entries.map(({ record, variant }) => {
    const values = columns.map(({ of }) => of(record));
    const sizes = values.map((value, place) => size_of(value, columns[place].name));
    return { variant, machine: letters([record]), failure: failure_of(record), values, sizes };
  });
  const places = columns.map((_, i) => i);
  // The least CPU time of several machines tells of these.
  const on_several = rows.some(({ machine }) => machine !== "");
  const ranges = columns.map(({ name }, place) =>
    name === WORK && on_several ? null : range_of(rows, place, name),
  );
  const body = h("tbody");
  const heads = columns.map(({ name, unit, meaning }, place) =>
    h(
      "th",
      { scope: "col", class: "number", title: meaning },
      h(
        "button",
        { type: "button", onclick: () => sort(place) },
        name,
        unit && h("span", { class: "unit" }, ` ${unit}`),
      ),
    ),
  );
  const row = ({ variant, machine, failure, values, sizes }) =>
    h(
      "tr",
      {
        class: [failure && "failed", variant.label === chosen && "chosen"]
          .filter(Boolean)
          .join(" "),
      },
      h(
        "th",
        { scope: "row" },
        variant.words,
        machine_mark(machine),
        failure && [" ", h("span", { class: "failed-why" }, `✕ ${failure}`)],
      ),
      with_contacts && h("td", {}, variant.contacts),
      values.map((value, place) => cell(value, sizes[place], ranges[place], failure !== "")),
    );
  function sort(place) {
    heads.forEach((head, i) =>
      i === place ? head.setAttribute("aria-sort", "ascending") : head.removeAttribute("aria-sort"),
    );
    replace(body, ordered(rows, place, places).map(row));
  }
  sort(0);
  const failures = rows.filter(({ failure }) => failure).length;
  return h(
    "div",
    { class: "figures" },
    h(
      "div",
      { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "Figures side by side" },
      h(
        "table",
        { class: "compared" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            h("th", { scope: "col" }, heading),
            with_contacts && h("th", { scope: "col" }, "Contacts"),
            heads,
          ),
        ),
        body,
      ),
    ),
    h(
      "p",
      { class: "figures-words" },
      "◆ least of its column; bars: logarithmic, from the least to the largest. “never”: not reached ",
      "within the run. A heading sorts. ",
      failures > 0 &&
        h(
          "strong",
          {},
          `${failures} of ${rows.length} fail (✕); they are last and compete for no mark.`,
        ),
    ),
  );
}
