// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a sweep: who holds where two axes vary, and what was measured where one does.
import { group_by } from "../model/family.js";
import { format_count, to_number } from "../model/number.js";
import { counted } from "../model/verdict.js";
import { quantity_axis, rounded } from "./axes.js";
import { configuration_styles } from "./configuration_style.js";
import { numbered, tip, tip_number } from "./names.js";
import { VERDICT_LABELS, verdict_encoding } from "./palette.js";

const HEIGHT = 360; // px
const WIDTH = 600; // px, about
const MOST_MARKS = 20_000;
const BY_FACTORS = 50;

const shown_unit = (unit) => (unit === "deg" ? "°" : unit);
const value_of = (record, name) => {
  const axis = record.axes.find((one) => one.name === name);
  return axis ? to_number(axis.value) : NaN;
};

/** The axes of some records with more than one value: [{name, unit, values}], values in order. */
export function varying_axes(records) {
  return records[0].axes
    .map(({ name, unit }) => ({
      name,
      unit: shown_unit(unit),
      values: [...new Set(records.map((record) => value_of(record, name)))].sort((a, b) => a - b),
    }))
    .filter(({ values }) => values.length > 1);
}

const is_log = ({ values }) => values[0] > 0 && values.at(-1) / values[0] >= BY_FACTORS;

// With room for the marks at its ends.
function axis_of(field, axis) {
  const encoding = quantity_axis(field, axis.name, axis.unit, { log: is_log(axis), grid: false });
  return { ...encoding, scale: { ...encoding.scale, nice: false, padding: 12 } };
}

// Marks as large as fit beside each other.
function size_of([across, up]) {
  const side = Math.min(WIDTH / across.values.length, HEIGHT / up.values.length);
  return Math.round(Math.min(160, Math.max(6, (0.62 * side) ** 2)));
}

function tally(records) {
  const groups = group_by(records, ({ verdict }) => verdict);
  return [...groups]
    .map(([verdict, group]) => counted(verdict, group.length, format_count(group.length)))
    .join(", ");
}

function diagram(name, records, axes) {
  const [across, up] = axes;
  const shown = records.slice(0, MOST_MARKS);
  const values = shown.map((record) => ({
    x: rounded(value_of(record, across.name)),
    y: rounded(value_of(record, up.name)),
    verdict: record.verdict,
    ...(record.checks.length > 0 && { value: rounded(to_number(record.checks[0].value)) }),
  }));
  const measured = records.find(({ checks }) => checks.length > 0)?.checks[0].quantity;
  return {
    kind: "phase-diagram",
    title: `${name}: over ${across.name} and ${up.name}`,
    caption:
      `${tally(records)}.` +
      (records.length > shown.length ? ` The first ${format_count(shown.length)} are drawn.` : ""),
    description: `${up.name} over ${across.name}: ${tally(records)}`,
    spec: {
      height: HEIGHT,
      data: { values },
      mark: { type: "point", filled: true, opacity: 1, size: size_of(axes) },
      encoding: {
        x: axis_of("x", across),
        y: axis_of("y", up),
        ...verdict_encoding({ labelExpr: VERDICT_LABELS, values: [...new Set(values.map(({ verdict }) => verdict))] }),
        tooltip: [
          tip_number("x", across.name),
          tip_number("y", up.name),
          tip("verdict", "verdict"),
          ...(measured ? [tip_number("value", measured)] : []),
        ],
      },
    },
  };
}

// A curve a configuration, of each check's value.
function curves(groups, axis) {
  const names = [...groups.keys()];
  const styles = configuration_styles(names);
  const keys = numbered(names);
  const first = [...groups.values()].flat().find(({ checks }) => checks.length > 0);
  if (!first) return [];
  return first.checks.map(({ quantity, unit }, place) => {
    const values = names.flatMap((name) =>
      groups
        .get(name)
        .filter(({ checks }) => checks[place]?.quantity === quantity)
        .map((record) => ({
          configuration_key: keys.key_of(name),
          x: rounded(value_of(record, axis.name)),
          y: rounded(to_number(record.checks[place].value)),
          verdict: record.verdict,
        })),
    );
    const look = (field) => names.map((name) => styles.get(name)[field]);
    return {
      kind: "phase-diagram",
      title: `${quantity} over ${axis.name}`,
      caption: names.map((name) => `${name}: ${tally(groups.get(name))}`).join("; "),
      description: `${quantity} over ${axis.name}`,
      spec: {
        height: HEIGHT / 1.4,
        data: { values },
        mark: { type: "line", point: { filled: true, size: 36 }, strokeWidth: 1.6 },
        encoding: {
          x: axis_of("x", axis),
          y: quantity_axis("y", quantity, shown_unit(unit)),
          color: {
            field: "configuration_key",
            type: "ordinal",
            scale: { domain: keys.keys, range: look("colour") },
            legend: names.length > 1 ? { labelExpr: keys.labels } : null,
          },
          tooltip: [tip_number("x", axis.name), tip_number("y", quantity), tip("verdict", "verdict")],
        },
      },
    };
  });
}

/** The plots of a sweep's records, none of others. `name_of(record)` is what its configuration is called. */
export function phase_diagrams(records, name_of) {
  const points = records.filter(({ axes }) => axes?.length > 0);
  if (points.length === 0) return [];
  const axes = varying_axes(points);
  const groups = group_by(points, name_of);
  if (axes.length === 1) return curves(groups, axes[0]);
  if (axes.length !== 2) return [];
  return [...groups].map(([name, group]) => diagram(name, group, axes));
}
