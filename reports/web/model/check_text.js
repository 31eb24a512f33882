// SPDX-License-Identifier: GPL-3.0-or-later
// Phrases about a check that several outputs share.
import { format_error, format_pair, general, format_value, to_number, with_unit } from "./number.js";

const error_unit = (check) => (check.relative ? "rel" : check.unit);

/** "1.2e-05 m", or "1.2e-05 rel" when the error is relative. */
export const error_text = (check) =>
  with_unit(format_error(to_number(check.error)), error_unit(check));

export const tolerance_text = (check) =>
  with_unit(format_error(to_number(check.tolerance)), error_unit(check));

// Measured and expected, with the digits that it takes to see that they differ.
const pair = (check) => format_pair(to_number(check.value), to_number(check.expected));

export const value_text = (check) => with_unit(pair(check)[0], check.unit);

export const expected_text = (check) => with_unit(pair(check)[1], check.unit);

/**
 * What its band says of a check's value: "expected in [1e-6, 1e-5] m", "worse than expected […]", "better
 * than known […]: raise the bar"; empty without a band. As band_text() in reports/text/check_text.h.
 */
export function band_text(check) {
  if (!check.band) return "";
  const [low, high, value, claim] = [...check.band, check.value, check.expected].map(to_number);
  const ends = with_unit(`[${format_value(low)}, ${format_value(high)}]`, check.unit);
  const inside = value >= low && value <= high;
  if (inside && check.verdict !== "fail") return `as expected in ${ends}`;
  if (Number.isNaN(value)) return `no number where it is expected in ${ends}`;
  const nearest = Math.min(Math.abs(low - claim), Math.abs(high - claim));
  return inside || Math.abs(value - claim) < nearest
    ? `better than known ${ends}: raise the bar`
    : `worse than expected ${ends}`;
}

/** |error| ÷ tolerance, as the record has it: the check holds up to 1. */
export const margin = (check) => to_number(check.of_tolerance);

/** The margin in short, as share_text() in reports/text/check_text.h: "12 %", "320 ×". */
export function short_margin(value) {
  if (value === 0) return "exact";
  if (!Number.isFinite(value)) return "∞";
  if (value > 1e5) return `${general(value, 1)} ×`;
  if (value < 1e-4) return "<0.01 %";
  // What is beyond its tolerance shall not read as 1.
  if (value > 1 && value < 1.05) return `${Number(value.toPrecision(4))} ×`;
  const plain = (number) => format_value(Number(number.toPrecision(2)));
  return value > 1 ? `${plain(value)} ×` : `${plain(value * 100)} %`;
}

/** The margin in words: "12 % of its tolerance", "320 × its tolerance". */
export function margin_text(value) {
  if (value === 0) return "exact";
  if (!Number.isFinite(value)) return "beyond any tolerance";
  const short = short_margin(value);
  return short.endsWith("×") ? `${short} its tolerance` : `${short} of its tolerance`;
}
