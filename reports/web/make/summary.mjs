// SPDX-License-Identifier: GPL-3.0-or-later
// The answer in short: which configuration holds, where it falls short, how it creeps, how near to its
// tolerances it comes and at what cost. A table configuration × family, and two pictures.
import { margin } from "../model/check_text.js";
import { column_names } from "../model/column_name.js";
import { ordered_configurations } from "../model/configuration.js";
import { family_name, group_by } from "../model/family.js";
import { machine_letters } from "../model/machine.js";
import { to_number } from "../model/number.js";
import { is_decided, is_expected, VERDICTS, worst_check } from "../model/verdict.js";
import { shared_cases_of, work_points } from "../model/work.js";
import { slip_plot } from "../plots/slip_plot.js";
import { work_precision_plot } from "../plots/work_precision_plot.js";
import { short_number } from "./index_row.mjs";

const CREEP = /\b(creep|drift|contact slip|mean slip|slip (up|down)hill)\b/i;

/** Whether a check tells that something at rest moves. */
export const is_of_creep = ({ quantity, unit }) =>
  CREEP.test(quantity) && ["m", "m/s"].includes(unit);

const holds_not = (verdict) => verdict === "fail" || is_expected(verdict);

// Counts of verdicts, as [verdict, count] in their order, and the decided check that comes nearest to its
// tolerance or is furthest beyond.
function cell_of(records) {
  const counts = VERDICTS.map((verdict) => [
    verdict,
    records.filter((record) => record.verdict === verdict).length,
  ]).filter(([, count]) => count > 0);
  let worst = null;
  for (const record of records)
    for (const check of record.checks)
      if (is_decided(check.verdict) && !(margin(check) <= worst?.margin))
        worst = { margin: margin(check), case: record.case, quantity: check.quantity };
  const cases = [...new Set(records.map((record) => record.case))];
  const held = records
    .flatMap(({ checks }) => checks)
    .filter(({ verdict }) => verdict === "pass")
    .reduce((most, check) => Math.max(most, margin(check)), 0);
  return {
    counts,
    worst: worst && { ...worst, margin: short_number(worst.margin) },
    nearest: short_number(held),
    cases: cases.length,
    ...(cases.length === 1 && { case: cases[0] }),
  };
}

// In how many of the cases that look for it something at rest moves, and how fast at most.
function creep_of(records) {
  const looked = records.filter(({ checks }) =>
    checks.some((check) => is_of_creep(check) && is_decided(check.verdict)),
  );
  const creeping = looked.filter(({ checks }) =>
    checks.some((check) => is_of_creep(check) && holds_not(check.verdict)),
  );
  const speeds = looked.flatMap((record) =>
    record.checks
      .filter((check) => is_of_creep(check) && is_decided(check.verdict) && check.unit === "m/s")
      .map((check) => ({ value: Math.abs(to_number(check.value)), case: record.case })),
  );
  const fastest = speeds
    .filter(({ value }) => Number.isFinite(value))
    .reduce((a, b) => (a && a.value >= b.value ? a : b), null);
  return { looked: looked.length, creeping: creeping.length, fastest };
}

const sum_of = (records) =>
  records.reduce((sum, { cost }) => sum + Math.max(0, to_number(cost.cpu_seconds) || 0), 0);

// Families with something that fails come first, then those that fall short, then those that hold.
function place_of({ cells }) {
  const verdicts = cells.flatMap((cell) => cell?.counts.map(([verdict]) => verdict) ?? []);
  const of = VERDICTS.map((verdict) => verdicts.includes(verdict));
  const place = of.indexOf(true);
  return place < 0 || place >= VERDICTS.indexOf("pass") ? VERDICTS.length : place;
}

// What the causes of shortfalls come down to, a record's worst one each, most frequent first: [{because,
// records, configurations, case}], the case being the one furthest beyond.
function causes_of(records, name_of) {
  const checks = records
    .filter(({ verdict }) => is_expected(verdict))
    .map((record) => ({ record, check: worst_check(record.checks, margin) }))
    .filter(({ check }) => check?.because);
  return [...group_by(checks, ({ check }) => check.because)]
    .map(([because, list]) => ({
      because,
      records: list.length,
      configurations: ordered_configurations(list.map(({ record }) => name_of(record))),
      case: list.reduce((a, b) => (margin(b.check) > margin(a.check) ? b : a)).record.case,
    }))
    .sort((a, b) => b.records - a.records);
}

/**
 * {configurations, families, work, slip}: the table and the pictures of the records that are judged;
 * null where there are none.
 */
export function summary_of(records) {
  const judged = records.filter(({ verdict }) => verdict !== "not-applicable");
  if (judged.length === 0) return null;
  const name_of = column_names(judged);
  const by_configuration = group_by(judged, name_of);
  const names = ordered_configurations(by_configuration.keys());
  const letters = machine_letters(judged);
  const families = [...group_by(judged, (record) => family_name(record.case))].map(
    ([name, own]) => {
      const cells = group_by(own, name_of);
      return { name, cells: names.map((one) => (cells.has(one) ? cell_of(cells.get(one)) : null)) };
    },
  );
  const points = work_points(judged, name_of);
  const shared = shared_cases_of(judged, name_of);
  const broken = group_by(
    points.filter(({ broke }) => broke),
    ({ configuration }) => configuration,
  );
  const shared_set = new Set(shared.cases);
  const work = work_precision_plot(judged, { name_of, height: 230, always: true });
  const slip = slip_plot(judged, name_of);
  return {
    shared: { cases: shared.cases.length, configurations: shared.configurations.length },
    configurations: names.map((name) => {
      const own = by_configuration.get(name);
      return {
        name,
        ...cell_of(own),
        seconds: short_number(sum_of(own)),
        machines: letters(own),
        creep: creep_of(own),
        broke: broken.get(name)?.length ?? 0,
        shared: shared.configurations.includes(name)
          ? cell_of(own.filter((record) => shared_set.has(record.case)))
          : null,
      };
    }),
    families: families
      .map((family) => ({ ...family, place: place_of(family) }))
      .sort((a, b) => a.place - b.place)
      .map(({ place, ...family }) => ({ ...family, all_hold: place === VERDICTS.length })),
    causes: causes_of(judged, name_of),
    work: work && { id: "summary/work", kind: "work-precision", ...work },
    slip: slip && { id: "summary/slip", kind: "series", ...slip },
  };
}
