// SPDX-License-Identifier: GPL-3.0-or-later
// What the points of a sweep measured: of each check a map a configuration, in the same colours.
import { tolerance_text, value_text } from "../model/check_text.js";
import { format_value, to_number, with_unit } from "../model/number.js";
import { is_decided } from "../model/verdict.js";
import { colour_scale } from "./colour_scale.js";
import { heat_map } from "./heat_map.js";
import { shown_unit } from "../model/sweep.js";

// A point of a check's map.
function point_of(record, quantity) {
  const check = record.checks.find((one) => one.quantity === quantity);
  const value = check ? to_number(check.value) : NaN;
  if (record.verdict === "error") return { record, value: null, text: "–", missing: "broke off" };
  if (!check) return { record, value: null, text: "–", missing: "not measured" };
  if (!Number.isFinite(value))
    return { record, value: null, text: String(check.value), missing: "no finite number" };
  return { record, value, text: `${value_text(check)}, ${check.verdict}` };
}

const shared = (values) =>
  values.length > 0 && values.every((value) => value === values[0]) ? values[0] : undefined;

// What the check allows, where it is the same at all points.
function tolerance_sentence(checks) {
  const judged = checks.filter(({ verdict }) => is_decided(verdict));
  const tolerance = shared(judged.map(tolerance_text));
  if (tolerance === undefined) return "";
  const expected = shared(judged.map((check) => to_number(check.expected)));
  const about =
    expected === undefined
      ? ""
      : ` ${with_unit(format_value(expected), shown_unit(judged[0].unit))},`;
  return expected === undefined
    ? `Judged by a tolerance ${tolerance}.`
    : `Expected:${about} tolerance ${tolerance}.`;
}

/** The maps of `series`, [{name, records}], over a layout. */
export function value_maps(series, layout) {
  const all = series.flatMap(({ records }) => records);
  const quantities = new Map(
    all.flatMap(({ checks }) => checks.map((check) => [check.quantity, check.unit])),
  );
  return [...quantities].flatMap(([quantity, unit]) => {
    const points = series.map(({ records }) => records.map((record) => point_of(record, quantity)));
    const values = points
      .flat()
      .map(({ value }) => value)
      .filter((value) => value !== null);
    if (values.length === 0) return [];
    const scale = colour_scale(values, quantity, shown_unit(unit));
    return series.flatMap(({ name, records }, i) => {
      if (points[i].every(({ missing }) => missing === "not measured")) return [];
      const checks = records.flatMap((record) =>
        record.checks.filter((check) => check.quantity === quantity),
      );
      return heat_map({
        title: series.length > 1 ? `${name}: ${quantity}` : quantity,
        points: points[i],
        layout,
        scale,
        notes: [tolerance_sentence(checks)],
        value_name: quantity,
      });
    });
  });
}
