// SPDX-License-Identifier: GPL-3.0-or-later
// Values as colours. The palette's $v0 to $v6 are matplotlib's viridis, whose lightness grows evenly, also for
// the colour-blind; the end that the page's ground would swallow is cut off: the palest in the light theme, the
// darkest in the dark one.
import { name_with_unit } from "../model/number.js";
import { PALETTES } from "./palette.js";
import { LOG_LABELS, rounded } from "./axes.js";

const BY_FACTORS = 50; // from the least to the largest value: the scale is logarithmic
const DECADES = 1e3; // from there on powers of ten are enough to label it

export const VALUE_COLOURS = ["$v0", "$v1", "$v2", "$v3", "$v4", "$v5", "$v6"];

// CIE lightness of "#rrggbb", 0 to 100.
function lightness(colour) {
  const [r, g, b] = [1, 3, 5].map((at) => {
    const part = Number.parseInt(colour.slice(at, at + 2), 16) / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  const y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  return y > 0.008856 ? 116 * Math.cbrt(y) - 16 : 903.3 * y;
}

/** By how much each colour of the scale is lighter than the one before it. */
export function luminance_steps(theme) {
  const all = VALUE_COLOURS.map((colour) => lightness(PALETTES[theme][colour]));
  return all.slice(1).map((value, i) => value - all[i]);
}

const extent = (values) => [
  values.reduce((a, b) => Math.min(a, b), Infinity),
  values.reduce((a, b) => Math.max(a, b), -Infinity),
];

// Of values without a sign.
function spans_decades(values) {
  const [low, high] = extent(values.filter((value) => value > 0));
  return high / low >= BY_FACTORS;
}

// Where all are the same, that has the middle colour.
function widened([low, high], log) {
  if (low < high) return [low, high];
  if (log) return [low / 10, low * 10];
  return low === 0 ? [-1, 1] : [low - Math.abs(low) / 2, low + Math.abs(low) / 2];
}

/**
 * How the finite `values` of a quantity are coloured: {channel, of(value): what stands in the data, words: for the
 * caption}. What spans decades has a logarithmic scale; what also has both signs is coloured by its size.
 */
export function colour_scale(values, quantity, unit) {
  const sizes = values.map(Math.abs);
  const signed = values.some((value) => value < 0);
  const log = spans_decades(sizes);
  const by_size = signed && log;
  const shown = by_size ? sizes : values;
  const domain = widened(extent(log ? shown.filter((value) => value > 0) : shown), log);
  const with_zero = log && shown.includes(0);
  return {
    of: (value) => {
      const size = by_size ? Math.abs(value) : value;
      return log && size === 0 ? rounded(domain[0]) : rounded(size);
    },
    words: [
      by_size && "Coloured by the size of the value, whatever its sign.",
      with_zero && "Zeros have the lowest colour.",
    ]
      .filter(Boolean)
      .join(" "),
    channel: {
      field: "colour",
      type: "quantitative",
      scale: {
        type: log ? "log" : "linear",
        domain: domain.map(rounded),
        nice: false,
        range: VALUE_COLOURS,
      },
      legend: {
        title: `${name_with_unit(by_size ? `|${quantity}|` : quantity, unit)} `, // the space as in names.js
        type: "gradient",
        direction: "horizontal",
        gradientLength: 240,
        gradientThickness: 12,
        titleLimit: 300,
        tickCount: 5,
        labelExpr:
          log && domain[1] / domain[0] >= DECADES ? LOG_LABELS : "format(datum.value, '.3~g')",
        labelOverlap: true,
      },
    },
  };
}
