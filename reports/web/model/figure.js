// SPDX-License-Identifier: GPL-3.0-or-later
// What a run of `./stiction compare` measured: figures that stand side by side and are judged by nobody.
import { format_value, to_number } from "./number.js";

/** What a comparison's work is measured by, where it is one of its figures. */
export const WORK = "CPU time";

/** Whether records are those of a comparison. */
export const is_comparison = (records) => records.some(({ figures }) => figures.length > 0);

/** The quantities that were compared, each once: [{quantity, unit, meaning}]. */
export function compared_quantities(records) {
  const all = records.flatMap(({ figures }) => figures);
  return [...new Map(all.map((figure) => [figure.quantity, figure])).values()];
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
  const found = record.figures.find((figure) => figure.quantity === quantity);
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

/** "it broke at gain = -0.5, 2.3" */
export const failure_text = ({ reason, parameter, values }) =>
  `${reason} at ${parameter} = ${values.map((value) => figure_text(to_number(value))).join(", ")}`;

/** Why a record failed, in words; "" when it did not. */
export function failure_of(record) {
  if (record.verdict === "error") return record.error || "broke off";
  return record.failures.find(({ values }) => values.length === 0)?.reason ?? "";
}

/** Whether it failed at some values of a parameter, but not as a whole. */
export const failed_in_part = (record) =>
  failure_of(record) === "" && record.failures.length > 0;

/** The values of a parameter at which a sweep over it failed. */
export const failed_values = (record, wanted) =>
  record.failures
    .filter(({ parameter }) => parameter === wanted)
    .flatMap(({ values }) => values.map(to_number));
