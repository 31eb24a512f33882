// SPDX-License-Identifier: GPL-3.0-or-later
// The channels by which the variants of a plot are told apart: colour and shape and dash of their
// configurations, over the data's `variant_key`.
import { group_by } from "../model/family.js";
import { variant_styles } from "./configuration_style.js";
import { numbered } from "./names.js";

const PALER = 0.5;

/** As many are drawn where each has a curve of its own. */
export const MOST_VARIANTS = 7;

/** As many of `curves` as can be told apart: of each configuration the first, then the second, …; in their order. */
export function told_apart(curves) {
  const places = [...group_by(curves, ({ configuration }) => configuration).values()];
  const chosen = new Set();
  for (let turn = 0; chosen.size < Math.min(MOST_VARIANTS, curves.length); ++turn)
    for (const group of places)
      if (turn < group.length && chosen.size < MOST_VARIANTS) chosen.add(group[turn]);
  return curves.filter((curve) => chosen.has(curve));
}

/** What a caption says where not all variants are drawn. */
export const cut_words = (variants) =>
  variants > MOST_VARIANTS ? `${MOST_VARIANTS} of ${variants} variants, the first of each configuration.` : "";

/**
 * For `variants`, [{label, configuration}] with distinct labels: {names: as numbered() gives them, styles,
 * channel(range, legend): a channel with a legend, colour, shape, dash: ranges}.
 */
export function variant_channels(variants) {
  const names = numbered(variants.map(({ label }) => label));
  const styles = variant_styles(variants.map(({ configuration }) => configuration));
  return {
    names,
    styles,
    colours: styles.map(({ colour }) => colour),
    shapes: styles.map(({ shape }) => shape),
    dashes: styles.map(({ dash }) => dash),
    // Where only colours can be told: from the second of a configuration on they are paler.
    opacities: variants.map(({ configuration }, i) =>
      variants.findIndex((one) => one.configuration === configuration) === i ? 1 : PALER,
    ),
    channel: (range, legend = {}) => ({
      field: "variant_key",
      type: "ordinal",
      scale: { domain: names.keys, range },
      legend: names.keys.length > 1 ? { labelExpr: names.labels, ...legend } : null,
    }),
  };
}
