// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison in short, for the summary: how much was compared, and of each case who is best.
import { chief_quantity, failed_in_part, failure_of, figure_of } from "../model/figure.js";
import { group_by } from "../model/family.js";
import { machine_letters } from "../model/machine.js";
import { to_number } from "../model/number.js";
import { comparison_scores, variants_of } from "../plots/plots.js";
import { winners_of } from "./winners.mjs";

function case_line([name, group], letters) {
  const records = group.map(({ record }) => record);
  const chief = chief_quantity(records);
  const held = group
    .filter(({ record }) => failure_of(record) === "")
    .map(({ record, variant }) => ({
      label: [variant.name, variant.contacts].filter(Boolean).join(" · "),
      value: figure_of(record, chief?.quantity),
    }))
    .filter(({ value }) => Number.isFinite(value))
    .sort((a, b) => a.value - b.value);
  return {
    case: name,
    title: records[0].title,
    quantity: chief?.quantity ?? "",
    unit: chief?.unit ?? "",
    best: held[0] ?? null,
    middle: held[held.length >> 1]?.value ?? null,
    worst: held.at(-1) ?? null,
    records: records.length,
    failed: records.length - group.filter(({ record }) => failure_of(record) === "").length,
    in_part: records.filter(failed_in_part).length,
    seconds: records.reduce((sum, { cost }) => sum + to_number(cost.cpu_seconds), 0),
    machines: letters(records),
  };
}

/** `entries`: [{record, run}] of the runs that are shown, in the order of the cases' names. */
export function compared_of(entries, runs) {
  const variants = variants_of(entries, runs);
  const letters = machine_letters(entries.map(({ record }) => record));
  const told = entries.map(({ record }, i) => ({ record, variant: variants[i] }));
  const cases = [...group_by(told, ({ record }) => record.case)].map((one) =>
    case_line(one, letters),
  );
  return {
    rules: new Set(variants.map(({ words }) => words)).size,
    figures: entries.reduce((sum, { record }) => sum + record.figures.length, 0),
    failed: cases.reduce((sum, { failed }) => sum + failed, 0),
    cases,
    winners: winners_of(told),
    scores: comparison_scores(entries, runs),
  };
}
