// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity over time, all variants of a case in one picture.
import { to_number } from "../model/number.js";
import { log_domain, quantity_axis, rounded, wants_log } from "./axes.js";
import { numbered, tip, tip_number } from "./names.js";
import { SERIES_COLOURS, SERIES_DASHES } from "./palette.js";

export const MOST_VARIANTS = 7;

/** What a caption says where not all variants are drawn. */
export const cut_words = (variants) =>
  variants > MOST_VARIANTS ? `The first ${MOST_VARIANTS} of ${variants} variants.` : "";

const STROKES = { symbolType: "stroke", symbolSize: 400 };

/** One of the variants' channels (colour, dash, shape) over data's `variant_key`. `variants`: numbered(). */
export function variant_channel(variants, range, legend = {}) {
  return {
    field: "variant_key",
    type: "ordinal",
    scale: { domain: variants.keys, range },
    legend: variants.keys.length > 1 ? { labelExpr: variants.labels, ...legend } : null,
  };
}

/** `curves`: [{label, series}], series of the same name, units and x. */
export function series_plot(curves) {
  const shown = curves.slice(0, MOST_VARIANTS);
  const { name, unit, x_name, x_unit } = shown[0].series;
  const variants = numbered(shown.map(({ label }) => label));
  const values = shown.flatMap(({ label, series }) =>
    series.x.map((x, i) => ({
      variant: label,
      variant_key: variants.key_of(label),
      x: rounded(to_number(x)),
      y: rounded(to_number(series.y[i])),
    })),
  );
  const ys = values.map(({ y }) => y).filter((y) => y !== null);
  const log = wants_log(ys);
  const domain = log ? log_domain(ys) : undefined;
  if (log) for (const value of values) if (value.y === 0) value.y = domain[0];
  const with_zero = log && curves.some(({ series }) => series.y.includes(0));
  return {
    title: `${name} over ${x_name}`,
    caption: [
      cut_words(curves.length),
      with_zero && "Zeros stand at the lower edge of the logarithmic axis.",
    ]
      .filter(Boolean)
      .join(" "),
    description: `${name} over ${x_name}: ${shown.length} curve${shown.length > 1 ? "s" : ""}.`,
    spec: {
      height: 200,
      data: { values },
      mark: { type: "line", interpolate: "linear", strokeCap: "butt", clip: true },
      encoding: {
        x: quantity_axis("x", x_name, x_unit),
        y: quantity_axis("y", name, unit, { log, domain }),
        color: variant_channel(variants, SERIES_COLOURS, STROKES),
        strokeDash: variant_channel(variants, SERIES_DASHES, STROKES),
        // The first is thick and pale, later ones lie on it: equal curves are both seen.
        strokeWidth: {
          field: "variant_key",
          type: "ordinal",
          scale: {
            domain: variants.keys,
            range: shown.map((_, i) => (i === 0 && shown.length > 1 ? 5 : 1.75)),
          },
          legend: null,
        },
        opacity: {
          field: "variant_key",
          type: "ordinal",
          scale: {
            domain: variants.keys,
            range: shown.map((_, i) => (i === 0 && shown.length > 1 ? 0.45 : 1)),
          },
          legend: null,
        },
        tooltip: [tip("variant", "variant"), tip_number("x", x_name), tip_number("y", name)],
      },
    },
  };
}
