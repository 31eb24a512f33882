// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows are shown, in which order: pure functions of the route's options.
import { rank } from "../../model/verdict.js";

const words_of = (query) => query.toLowerCase().split(/\s+/).filter(Boolean);

const haystacks = new WeakMap();

function haystack(row) {
  let text = haystacks.get(row);
  if (text === undefined) {
    text =
      `${row.case} ${row.title} ${row.engine} ${row.variant} ${row.configuration} ${row.quantities} ${row.frames ? "recorded" : ""}`.toLowerCase();
    haystacks.set(row, text);
  }
  return text;
}

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
      (words.length === 0 || words.every((word) => haystack(row).includes(word))),
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
