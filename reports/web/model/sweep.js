// SPDX-License-Identifier: GPL-3.0-or-later
// Records that are points of sweeps: what was varied, over which values, and which points belong together.
import { group_by, short_name } from "./family.js";
import { to_number } from "./number.js";

const SCATTERED = 0.75; // of the points have a value of their own, on each axis

/** A unit as it is written. */
export const shown_unit = (unit) => (unit === "deg" ? "°" : unit);

/** What a point's value of an axis is. */
export function axis_value(record, name) {
  const axis = record.axes.find((one) => one.name === name);
  return axis ? to_number(axis.value) : NaN;
}

// How far values, in order, are from being evenly spaced: 0 to 1.
function unevenness(values) {
  const [low, high] = [values[0], values.at(-1)];
  const apart = values.map((value, i) =>
    Math.abs((value - low) / (high - low) - i / (values.length - 1)),
  );
  return apart.reduce((a, b) => Math.max(a, b), 0);
}

// Whether values are spaced by factors rather than by differences: then their axis is logarithmic.
const by_factors = (values) =>
  values.length > 2 && values[0] > 0 && unevenness(values.map(Math.log)) < unevenness(values);

/** The axes of some points with more than one value: [{name, unit, values, log}], values in order. */
export function varying_axes(records) {
  return records[0].axes
    .map(({ name, unit }) => {
      const values = [...new Set(records.map((record) => axis_value(record, name)))]
        .filter(Number.isFinite)
        .sort((a, b) => a - b);
      return { name, unit: shown_unit(unit), values, log: by_factors(values) };
    })
    .filter(({ values }) => values.length > 1);
}

/** Whether points are of no grid, such as those of a Sobol sequence: hardly one shares a value with another. */
export const is_scattered = (records, axes) =>
  axes.every(({ values }) => values.length > SCATTERED * records.length);

// The case without the axes' values, which stand at its end.
function case_without_axes({ case: name, axes }) {
  const parts = name.split("/");
  const rest = parts.slice(0, -axes.length);
  const is_axis = (part, i) => part.startsWith(`${axes[i].name}=`);
  return parts.slice(-axes.length).every(is_axis) ? rest.join("/") : "";
}

// A point that was computed more than once counts as it was computed last.
const last_of_each = (records) => [...new Map(records.map((one) => [one.case, one])).values()];

/**
 * The sweeps among a family's `entries`, [{record, run}]: [{axes, series}], one for each set of axes; a
 * series, {name, records}, is the points of one configuration in one case, and of one run where runs have the
 * same points. `name_of(record)` and `series_of(entry)` are what a configuration is called.
 */
export function sweeps_of(entries, name_of, series_of) {
  const points = entries.filter(({ record }) => record.axes?.length > 0);
  const names_of = ({ record }) => JSON.stringify(record.axes.map(({ name }) => name));
  return [...group_by(points, names_of).values()].map((own) => {
    const several_cases = new Set(own.map(({ record }) => case_without_axes(record))).size > 1;
    const is_twice =
      new Set(own.map(({ record }) => `${name_of(record)}\n${record.case}`)).size < own.length;
    const called = (entry) =>
      [
        is_twice ? series_of(entry) : name_of(entry.record),
        several_cases && short_name(case_without_axes(entry.record)),
      ]
        .filter(Boolean)
        .join(" · ");
    const series = [...group_by(own, called)].map(([name, list]) => ({
      name,
      records: last_of_each(list.map(({ record }) => record)),
    }));
    return { axes: varying_axes(series.flatMap(({ records }) => records)), series };
  });
}
