// SPDX-License-Identifier: GPL-3.0-or-later
// Records as points of work and precision: CPU time and error ÷ tolerance of the worst check.
import { margin } from "./check_text.js";
import { configuration_of } from "./configuration.js";
import { group_by } from "./family.js";
import { to_number } from "./number.js";
import { worst_check } from "./verdict.js";

/** What changes only how much work is done; every other setting makes another curve. */
export const EFFORTS = ["dt", "sweeps", "cells"];

const MOST_COMPARED = 12; // configurations among which such a set is looked for

// The check that tells of a record: of those that decide, else of those for information that have a scale
// to be told by.
function telling_check(record) {
  const decided = worst_check(record.checks, margin);
  if (decided) return { check: decided, judged: true };
  const shown = record.checks.filter(
    ({ verdict, tolerance }) => verdict === "for-information" && to_number(tolerance) > 0,
  );
  const check = shown.reduce((a, b) => (a && margin(a) >= margin(b) ? a : b), undefined);
  return { check, judged: false };
}

/** Whether it ended before its time: an error, or a value that is no number. */
const broke_off = (record, check) =>
  record.verdict === "error" || (check !== undefined && !Number.isFinite(to_number(check.error)));

/**
 * [{case, configuration, record, seconds, ratio, quantity, judged, broke}] of the records that were measured
 * or broke off. Points of sweeps have maps of their own: their claims are the study's, and many fail by design.
 */
export function work_points(records, name_of = configuration_of) {
  return records
    .filter(({ point, verdict }) => !point && verdict !== "not-applicable")
    .map((record) => {
      const { check, judged } = telling_check(record);
      return {
        case: record.case,
        configuration: name_of(record),
        record,
        seconds: to_number(record.cost.cpu_seconds),
        ratio: check ? margin(check) : NaN,
        quantity: check?.quantity ?? "",
        judged: judged || record.verdict === "error",
        broke: broke_off(record, check),
      };
    })
    .filter(({ ratio, broke }) => broke || !Number.isNaN(ratio));
}

// All that is set but the effort.
function curve_key({ case: name, configuration, record }) {
  const rest = Object.entries(record.settings)
    .filter(([key]) => !EFFORTS.includes(key))
    .sort();
  return JSON.stringify([name, configuration, rest]);
}

/** Groups of two points or more that differ in their effort only, cheapest first. */
export function effort_groups(points) {
  return [...group_by(points, curve_key).values()]
    .filter((group) => group.length > 1)
    .map((group) => [...group].sort((a, b) => a.seconds - b.seconds));
}

const subsets = (list) =>
  list.reduce((all, one) => [...all, ...all.map((set) => [...set, one])], [[]]);

/**
 * The configurations for which (pairs of them) × (cases that all of them ran) is largest, and these cases, as
 * standings_of() in reports/text/standing.h: {configurations, cases: [names]}; empty below two.
 */
export function shared_cases(pairs) {
  const cases = new Map();
  for (const { case: name, configuration } of pairs)
    cases.set(configuration, (cases.get(configuration) ?? new Set()).add(name));
  const names = [...cases.keys()]
    .sort((a, b) => cases.get(b).size - cases.get(a).size)
    .slice(0, MOST_COMPARED);
  let best = { configurations: [], cases: [] };
  let most = 0;
  for (const set of subsets(names)) {
    if (set.length < 2) continue;
    const [first, ...others] = set.map((name) => cases.get(name));
    const shared = [...first].filter((name) => others.every((other) => other.has(name)));
    const size = ((set.length * (set.length - 1)) / 2) * shared.length;
    if (size <= most) continue;
    most = size;
    best = { configurations: set, cases: shared };
  }
  return best;
}

/** The same of records that are applicable. */
export const shared_cases_of = (records, name_of = configuration_of) =>
  shared_cases(
    records
      .filter(({ verdict }) => verdict !== "not-applicable")
      .map((record) => ({ case: record.case, configuration: name_of(record) })),
  );

/** {sums, cases}: a point for each configuration over the cases that shared_cases() gave. */
export function shared_sums(points, { configurations, cases }) {
  const wanted = new Set(cases);
  const sums = configurations.map((configuration) => {
    const own = points.filter(
      (point) => point.configuration === configuration && wanted.has(point.case),
    );
    return {
      case: "",
      configuration,
      quantity: "",
      judged: true,
      seconds: own.reduce((sum, { seconds }) => sum + seconds, 0),
      broke: own.some(({ broke }) => broke),
      ratio: own.reduce((most, { ratio }) => (ratio > most ? ratio : most), 0),
    };
  });
  return { sums, cases: cases.length };
}
