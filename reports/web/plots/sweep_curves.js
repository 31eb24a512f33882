// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep over one axis: of each check a curve a configuration, and what it cost, a curve a configuration and machine.
import { group_by } from "../model/family.js";
import { machine_names, timings_sentence } from "../model/machine.js";
import { to_number } from "../model/number.js";
import { axis_value, shown_unit } from "../model/sweep.js";
import { quantity_axis, rounded, wants_log } from "./axes.js";
import { variant_styles } from "./configuration_style.js";
import { numbered, tip, tip_number } from "./names.js";
import { tally } from "./phase_diagram.js";

const HEIGHT = 257; // px

// `curves`: [{name, configuration, points: [{record, y}]}].
function plot(curves, axis, { kind, quantity, unit, caption }) {
  const styles = variant_styles(curves.map(({ configuration }) => configuration));
  const keys = numbered(curves.map(({ name }) => name));
  const values = curves.flatMap(({ points }, curve_key) =>
    points.map(({ record, y }) => ({
      curve_key,
      x: rounded(axis_value(record, axis.name)),
      y: rounded(y),
      verdict: record.verdict,
      case: record.case,
    })),
  );
  const measured = values.map(({ y }) => y).filter((y) => y !== null);
  if (measured.length === 0) return [];
  const gaps = values.length - measured.length;
  const log = !measured.includes(0) && wants_log(measured);
  const legend =
    curves.length > 1 ? { labelExpr: keys.labels, symbolType: "stroke", symbolSize: 400 } : null;
  const x = quantity_axis("x", axis.name, axis.unit, { log: axis.log, grid: false });
  return [
    {
      kind,
      title: `${quantity} over ${axis.name}`,
      caption: [caption, gaps > 0 && `${gaps} without a finite number: gaps.`]
        .filter(Boolean)
        .join(" "),
      description: `${quantity} over ${axis.name}`,
      spec: {
        height: HEIGHT,
        data: { values },
        mark: {
          type: "line",
          point: { filled: true, size: 36, cursor: "pointer" },
          strokeWidth: 1.6,
        },
        encoding: {
          x: { ...x, scale: { ...x.scale, nice: false, padding: 12 } },
          y: quantity_axis("y", quantity, unit, { log }),
          color: {
            field: "curve_key",
            type: "ordinal",
            scale: { domain: keys.keys, range: styles.map(({ colour }) => colour) },
            legend,
          },
          strokeDash: {
            field: "curve_key",
            type: "ordinal",
            scale: { domain: keys.keys, range: styles.map(({ dash }) => dash) },
            legend,
          },
          tooltip: [
            tip_number("x", axis.name),
            tip_number("y", quantity),
            tip("verdict", "verdict"),
          ],
        },
      },
    },
  ];
}

/** Of `series`, [{name, records}], the curves of each check over an axis. */
export function value_curves(series, axis) {
  const checks = series.flatMap(({ records }) => records.flatMap((record) => record.checks));
  const caption = `${series.map(({ name, records }) => `${name}: ${tally(records)}`).join("; ")}.`;
  return [...new Map(checks.map((check) => [check.quantity, check.unit]))].flatMap(
    ([quantity, unit]) => {
      const point = (record) => {
        const check = record.checks.find((one) => one.quantity === quantity);
        return { record, y: check && record.verdict !== "error" ? to_number(check.value) : NaN };
      };
      const curves = series.map(({ name, records }) => ({
        name,
        configuration: name,
        points: records.map(point),
      }));
      return plot(curves, axis, {
        kind: "phase-diagram",
        quantity,
        unit: shown_unit(unit),
        caption,
      });
    },
  );
}

/** Their CPU time. What broke off has none that says anything. */
export function cost_curves(series, axis) {
  const all = series.flatMap(({ records }) => records);
  const named = machine_names(all);
  const point = (record) => {
    const seconds = to_number(record.cost.cpu_seconds);
    return { record, y: seconds > 0 && record.verdict !== "error" ? seconds : NaN };
  };
  const curves = series.flatMap(({ name, records }) =>
    [...group_by(records, (record) => named(name, record))].map(([called, own]) => ({
      name: called,
      configuration: name,
      points: own.map(point),
    })),
  );
  return plot(curves, axis, {
    kind: "sweep-cost",
    quantity: "CPU time",
    unit: "s",
    caption: timings_sentence(all),
  });
}
