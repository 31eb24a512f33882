// SPDX-License-Identifier: GPL-3.0-or-later
// Ladders: cases ladder/NAME/PARAMETER=VALUE, one a rung, that sweep a parameter until something breaks.
import { margin } from "./check_text.js";
import { is_bad, is_expected, rank, worst_check } from "./verdict.js";

const FOLDER = "ladder/";
const RUNG = /^ladder\/(.+)\/([^/=]+)=([^/=]+)$/;

export const is_ladder = (case_name) => case_name.startsWith(FOLDER);

/** {ladder, parameter, text, value} of a case's name: "mass-ratio", "top", "10", 10; null where it is no rung. */
export function rung_of(case_name) {
  const [, ladder, parameter, text] = RUNG.exec(case_name) ?? [];
  const value = Number(text);
  if (!ladder || text.trim() === "" || !Number.isFinite(value)) return null;
  return { ladder, parameter, text, value };
}

/** Whether a record holds: true, false, or null where nothing can be said. Of one for information: each check does. */
export function holds({ verdict, checks }) {
  if (verdict === "pass") return true;
  if (verdict === "for-information") return checks.every((check) => margin(check) <= 1);
  return is_bad(verdict) || is_expected(verdict) ? false : null;
}

/** The check that decides; of a record for information the one that is farthest off its tolerance. */
export function deciding_check({ verdict, checks }) {
  if (verdict !== "for-information") return worst_check(checks, margin);
  return checks.reduce((a, b) => (a && margin(a) >= margin(b) ? a : b), undefined);
}

/** Error ÷ tolerance of the check that decides; infinite where the run broke off, NaN without such a check. */
export function ratio_of(record) {
  const check = deciding_check(record);
  if (record.verdict === "error") return Infinity;
  return check ? margin(check) : NaN;
}

/** Of several records of one rung the one that counts: worst verdict first, then the larger ratio. */
export const worse_of = (a, b) =>
  rank(b.verdict) < rank(a.verdict) || (b.verdict === a.verdict && ratio_of(b) > ratio_of(a))
    ? b
    : a;

// Decades from 1; zero and what is negative are farther than any positive number, by how far they are below.
const distance = ({ value }) =>
  value > 0 ? Math.abs(Math.log10(value)) : 1000 - Math.min(0, value);

/**
 * Where a ladder holds. `rungs`: [{value, holds}] in any order; of them, sorted by value:
 * {lowest, highest}: ends of the rungs without a break around the one nearest to 1 that holds (by decades);
 * {below, above}: the first on each side that fails; {beyond}: how many hold past these; {decided}. What is
 * null was not there: without `lowest` no rung holds, and `above` is the failing one that is nearest to 1.
 */
export function span_of(rungs) {
  const decided = rungs.filter((rung) => rung.holds !== null).sort((a, b) => a.value - b.value);
  const nearest = (some) => some.reduce((a, b) => (a && distance(a) <= distance(b) ? a : b), null);
  const held = decided.filter((rung) => rung.holds);
  const none = { lowest: null, highest: null, below: null, above: null, beyond: 0 };
  if (held.length === 0) return { ...none, above: nearest(decided), decided: decided.length };
  const middle = decided.indexOf(nearest(held));
  let [first, last] = [middle, middle];
  while (decided[first - 1]?.holds) --first;
  while (decided[last + 1]?.holds) ++last;
  return {
    lowest: decided[first],
    highest: decided[last],
    below: decided[first - 1] ?? null,
    above: decided[last + 1] ?? null,
    beyond: held.length - (last - first + 1),
    decided: decided.length,
  };
}
