// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people read them, spelled as reports/text/number.h spells them.

/** A number of a record: a JSON number or "nan", "inf", "-inf". */
export function to_number(value) {
  if (typeof value === "number") return value;
  return { nan: NaN, inf: Infinity, "-inf": -Infinity }[value] ?? NaN;
}

// printf's %.<digits>g.
export function general(value, digits) {
  if (Number.isNaN(value)) return "nan";
  if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
  if (value === 0) return "0";
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  const power = Number(exponent);
  if (power < -4 || power >= digits) {
    const trimmed = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
    return `${trimmed}e${power < 0 ? "-" : "+"}${String(Math.abs(power)).padStart(2, "0")}`;
  }
  const fixed = value.toFixed(Math.max(0, digits - 1 - power));
  return fixed.includes(".") ? fixed.replace(/\.?0+$/, "") : fixed;
}

/** Six significant digits: measured and expected values. */
export const format_value = (value) => general(value, 6);

/** Two numbers with six digits, up to nine where it takes them to tell the two apart. */
export function format_pair(a, b) {
  let digits = 6;
  while (a !== b && digits < 9 && general(a, digits) === general(b, digits)) ++digits;
  return [general(a, digits), general(b, digits)];
}

/** Two significant digits: errors and tolerances. */
export const format_error = (value) => general(value, 2);

/** A power of ten that bounds something: "1e-4". */
export const format_bound = (value) => (value === 1 ? "1" : value.toExponential(0));

/** Digits of agreement, one decimal. */
export const format_digits = (value) =>
  Number.isFinite(value) ? value.toFixed(1) : general(value, 2);

/** CPU time, s. */
export function format_seconds(value) {
  return Math.abs(value) < 999.5 ? general(value, 3) : value.toFixed(0);
}

/** The same where space is short; below a millisecond only that. */
export const format_seconds_short = (value) =>
  value > 0 && value < 1e-3 ? "< 0.001" : value < 0.1 ? general(value, 2) : format_seconds(value);

/** Whole number with "," between thousands. */
export const format_count = (value) => String(value).replace(/\B(?=(\d{3})+$)/g, ",");

/** A large number in short: 92.4 M. */
export function format_short(value) {
  for (const [limit, sign] of [
    [1e9, "G"],
    [1e6, "M"],
    [1e3, "k"],
  ]) {
    if (value >= limit) return `${general(value / limit, 3)} ${sign}`;
  }
  return general(value, 3);
}

/** The dimensionless "1" and an empty unit are left out. */
export const with_unit = (number, unit) =>
  unit === "" || unit === "1" ? number : `${number} ${unit}`;

/** "time (s)"; the name alone when dimensionless. */
export const name_with_unit = (name, unit) =>
  unit === "" || unit === "1" ? name : `${name} (${unit})`;
