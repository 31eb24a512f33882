// SPDX-License-Identifier: GPL-3.0-or-later
// What a run of `./stiction compare` measured: figures that stand side by side and are judged by nobody.
import { format_value, to_number } from "./number.js";

const FAILED = "failed: ";

/** What a comparison's work is measured by, where it is one of its figures. */
export const WORK = "CPU time";

/** Whether a check is such a figure: it is shown, and has no tolerance ("none: …"). */
export const is_figure = (check) =>
  check.verdict === "shown" && to_number(check.tolerance) === 0 && /^none\b/.test(check.reason);

/** Whether records are those of a comparison. */
export const is_comparison = (records) =>
  records.some(({ checks }) => checks.some((check) => is_figure(check)));

/** The quantities that were compared, each once: [{quantity, unit, claim}]. */
export function compared_quantities(records) {
  const all = records.flatMap(({ checks }) => checks.filter(is_figure));
  return [...new Map(all.map((check) => [check.quantity, check])).values()];
}

/** The one by which a case is told: the first that has a unit; beside measured work the first other. */
export function chief_quantity(records) {
  const quantities = compared_quantities(records);
  const others = quantities.filter(({ quantity }) => quantity !== WORK);
  return others.length < quantities.length
    ? others[0]
    : (others.find(({ unit }) => unit !== "1") ?? others[0]);
}

/** A record's value of a quantity; NaN when it was not measured. */
export function figure_of(record, quantity) {
  const found = record.checks.find((check) => is_figure(check) && check.quantity === quantity);
  return found ? to_number(found.value) : NaN;
}

/** Three digits; what is not finite was never reached. */
export function figure_text(value) {
  if (Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return "never";
  return Number.isInteger(value) && Math.abs(value) < 1e6
    ? String(value)
    : format_value(Number(value.toPrecision(3)));
}

const failed_notes = (record) =>
  record.notes.filter((note) => note.startsWith(FAILED)).map((note) => note.slice(FAILED.length));

// "gain = -0.5, 2.3": values of a parameter, not the whole record.
const PARAMETER_VALUES = /^(\S+) = ([-+\d.e]+(?:, [-+\d.e]+)*)$/;

/** Why a record failed, in words; "" when it did not. */
export function failure_of(record) {
  if (record.verdict === "error") return record.error || "broke off";
  return failed_notes(record).find((text) => !PARAMETER_VALUES.test(text)) ?? "";
}

/** Whether it failed at some values of a parameter, but not as a whole. */
export const failed_in_part = (record) =>
  failure_of(record) === "" && failed_notes(record).length > 0;

/** The values of a parameter at which a sweep over it failed. */
export function failed_values(record, parameter) {
  return failed_notes(record)
    .map((text) => PARAMETER_VALUES.exec(text))
    .filter((found) => found?.[1] === parameter)
    .flatMap(([, , list]) => list.split(", ").map(Number));
}
