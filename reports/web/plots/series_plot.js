// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity over time, all variants of a case in one picture, with the tolerance that it is judged by.
import { to_number } from "../model/number.js";
import { log_domain, quantity_axis, rounded, wants_log } from "./axes.js";
import { tip, tip_number } from "./names.js";
import { tolerance_rules } from "./tolerance_rules.js";
import { cut_words, told_apart, variant_channels } from "./variant_channels.js";

const STROKES = { symbolType: "stroke", symbolSize: 400 };
const FAR = 4; // times the span of the values: a tolerance beyond that would flatten them

// Layers of the rules, and the words for those that lie too far away to be drawn on a linear axis.
function rules_of(curves, ys, log) {
  const all = tolerance_rules(curves, log);
  const low = ys.reduce((a, b) => Math.min(a, b), Infinity);
  const high = ys.reduce((a, b) => Math.max(a, b), -Infinity);
  const is_far = ({ y }) => !log && Math.max(low - y, y - high) > FAR * (high - low);
  return { drawn: all.filter((rule) => !is_far(rule)), far: all.filter(is_far) };
}

const NEAR = 1e-3;

// Whether another curve lies on the first for half of its length.
function lies_on_first([first, ...others]) {
  const near = (a, b) => Math.abs(a - b) <= NEAR * Math.max(Math.abs(a), Math.abs(b));
  const ys = first.series.y.map(to_number);
  return others.some(
    ({ series }) =>
      series.y.length === ys.length &&
      series.y.filter((y, i) => near(to_number(y), ys[i])).length > ys.length / 2,
  );
}

// Then the first is pale and thick: both are seen.
const first_and_others = (channels, first, others) => ({
  field: "variant_key",
  type: "ordinal",
  scale: {
    domain: channels.names.keys,
    range: channels.names.keys.map((_, i, { length }) => (i === 0 && length > 1 ? first : others)),
  },
  legend: null,
});

/** `curves`: [{label, configuration, series, record}], series of the same name, units and x. */
export function series_plot(curves, { height = 200 } = {}) {
  const shown = told_apart(curves);
  const { name, unit, x_name, x_unit } = shown[0].series;
  const channels = variant_channels(shown);
  const values = shown.flatMap(({ label, series }) =>
    series.x.map((x, i) => ({
      variant: label,
      variant_key: channels.names.key_of(label),
      x: rounded(to_number(x)),
      y: rounded(to_number(series.y[i])),
    })),
  );
  const ys = values.map(({ y }) => y).filter((y) => y !== null);
  const log = wants_log(ys);
  const { drawn, far } = rules_of(shown, ys, log);
  const domain = log ? log_domain([...ys, ...drawn.map(({ y }) => y)]) : undefined;
  if (log) for (const value of values) if (value.y === 0) value.y = domain[0];
  const with_zero = log && shown.some(({ series }) => series.y.includes(0));
  const covered = lies_on_first(shown);
  const gaps = values.length - ys.length;
  const encoding = {
    x: quantity_axis("x", x_name, x_unit),
    y: quantity_axis("y", name, unit, { log, domain }),
  };
  return {
    title: `${name} over ${x_name}`,
    caption: [
      cut_words(curves.length),
      drawn.length > 0 && "Dashed across: what the check allows.",
      far.length > 0 && `Beyond the axis: ${far.map(({ text }) => text).join("; ")}.`,
      with_zero && "Zeros stand at the lower edge of the logarithmic axis.",
      gaps > 0 && `${gaps} value${gaps > 1 ? "s are" : " is"} no finite number: a gap.`,
    ]
      .filter(Boolean)
      .join(" "),
    description: `${name} over ${x_name}: ${shown.length} curve${shown.length > 1 ? "s" : ""}.`,
    spec: {
      height,
      layer: [
        {
          data: { values },
          mark: { type: "line", interpolate: "linear", strokeCap: "butt", clip: true },
          encoding: {
            ...encoding,
            color: channels.channel(channels.colours, STROKES),
            strokeDash: channels.channel(channels.dashes, STROKES),
            strokeWidth: first_and_others(channels, covered ? 5 : 1.75, 1.75),
            opacity: first_and_others(channels, covered ? 0.45 : 1, 1),
            tooltip: [tip("variant", "variant"), tip_number("x", x_name), tip_number("y", name)],
          },
        },
        ...(drawn.length > 0
          ? [
              {
                data: { values: drawn },
                mark: { type: "rule", color: "$ink", strokeDash: [6, 3], strokeWidth: 1 },
                encoding: { y: encoding.y },
              },
              {
                data: { values: drawn },
                mark: { type: "text", align: "right", baseline: "bottom", dy: -2, color: "$ink" },
                encoding: {
                  x: { value: { expr: "width" } },
                  y: encoding.y,
                  text: { field: "text" },
                },
              },
            ]
          : []),
      ],
    },
  };
}
