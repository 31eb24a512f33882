// SPDX-License-Identifier: GPL-3.0-or-later
// The tolerances of checks in the plot of the quantity that they judge: dashed rules at the ends of what is
// allowed.
import { tolerance_text } from "../model/check_text.js";
import { to_number } from "../model/number.js";
import { is_decided } from "../model/verdict.js";
import { rounded } from "./axes.js";

const MOST_RULES = 4;

// "kinetic energy (last)" and "ground slip, μ = 0.24" tell which run; "fall at rest" tells when.
const bare = (name) =>
  name
    .replace(/\s*\([^)]*\)\s*$/, "")
    .replace(/,\s.*=.*$/, "")
    .trim();

/** Whether a check judges the quantity of a series: the same name and unit, perhaps at some time. */
export function judges(check, series) {
  const [quantity, name] = [bare(check.quantity), bare(series.name)];
  return check.unit === series.unit && (quantity === name || quantity.startsWith(`${name} at `));
}

/**
 * The rules for `curves`, [{series, record}] of one quantity: [{y, text}], each once. On a logarithmic axis
 * only what is positive.
 */
export function tolerance_rules(curves, log) {
  const rules = new Map();
  for (const { series, record } of curves) {
    for (const check of record?.checks ?? []) {
      if (!is_decided(check.verdict) || !judges(check, series)) continue;
      const expected = to_number(check.expected);
      const size = check.relative ? Math.abs(to_number(check.scale ?? check.expected)) : 1;
      const allowed = to_number(check.tolerance) * size;
      if (!(allowed > 0) || !Number.isFinite(expected)) continue;
      for (const sign of expected === 0 && log ? [1] : [1, -1]) {
        const y = rounded(expected + sign * allowed);
        if (y === null || (log && y <= 0)) continue;
        const when = check.quantity === series.name ? "" : `, ${check.quantity}`;
        rules.set(y, { y, text: `tolerance ${tolerance_text(check)}${when}` });
      }
    }
  }
  return [...rules.values()].slice(0, MOST_RULES);
}
