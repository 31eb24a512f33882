// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows are shown, in which order: pure functions of the route's options.
import { suite_of } from "../../model/suite.js";
import { rank } from "../../model/verdict.js";

const words_of = (query) => query.toLowerCase().split(/\s+/).filter(Boolean);

// Texts that many rows share are made small once.
const shared = new Map();

function lower(text) {
  let small = shared.get(text);
  if (small === undefined) shared.set(text, (small = text.toLowerCase()));
  return small;
}

const OWN = Symbol("what only this row is found by");

function own_text(row) {
  row[OWN] ??=
    `${row.case} ${row.title} ${row.frames ? "recorded" : ""} ${suite_of(row.case)}`.toLowerCase();
  return row[OWN];
}

const has_word = (row, word) =>
  own_text(row).includes(word) ||
  [row.engine, row.variant, row.configuration, row.quantities].some((text) =>
    lower(text).includes(word),
  );

/** `options`: {q, verdict: "fail,error", family, configuration, run}; all words of q must occur. */
export function filtered(
  rows,
  { q = "", verdict = "", family = "", configuration = "", run = "" },
) {
  const words = words_of(q);
  const verdicts = verdict ? new Set(verdict.split(",")) : null;
  return rows.filter(
    (row) =>
      (!verdicts || verdicts.has(row.verdict)) &&
      (!family || row.family === family) &&
      (!configuration || row.column === configuration) &&
      (run === "" || row.run === Number(run)) &&
      (words.length === 0 || words.every((word) => has_word(row, word))),
  );
}

const by_number = (value) =>
  Number.isFinite(value) ? value : value === Infinity ? Number.MAX_VALUE : -Number.MAX_VALUE;

/** What each column sorts by. Rows come in natural order of case names, which "case" keeps. */
export const SORT_KEYS = {
  verdict: (row) => rank(row.verdict),
  case: (row) => row.index,
  margin: (row) => by_number(row.check ? row.check.margin : -1),
  digits: (row) => by_number(row.check?.digits ?? Infinity),
  seconds: (row) => by_number(row.seconds),
  ns: (row) => by_number(row.ns),
};

/** `order` is a column's name, "-" before it for largest first. Equal rows keep their order. */
export function sorted(rows, order) {
  const descending = order.startsWith("-");
  const key = SORT_KEYS[descending ? order.slice(1) : order] ?? SORT_KEYS.case;
  const sign = descending ? -1 : 1;
  const keys = rows.map(key);
  const places = rows.map((_, i) => i).sort((a, b) => sign * (keys[a] - keys[b]) || a - b);
  return places.map((place) => rows[place]);
}
