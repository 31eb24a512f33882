// SPDX-License-Identifier: GPL-3.0-or-later
// The channels by which the variants of a plot are told apart: colour and shape and dash of their
// configurations, over the data's `variant_key`.
import { variant_styles } from "./configuration_style.js";
import { numbered } from "./names.js";

const PALER = 0.5;

/** As many are drawn where each has a curve of its own. */
export const MOST_VARIANTS = 7;

/** What a caption says where not all variants are drawn. */
export const cut_words = (variants) =>
  variants > MOST_VARIANTS ? `The first ${MOST_VARIANTS} of ${variants} variants.` : "";

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
