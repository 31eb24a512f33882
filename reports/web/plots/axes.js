// SPDX-License-Identifier: GPL-3.0-or-later
// Axis helpers that every plot shares.
import { name_with_unit } from "../model/number.js";

/** Powers of ten are labelled as such; other numbers in short. */
const IS_DECADE = "abs(log(datum.value) / LN10 - round(log(datum.value) / LN10)) < 1e-9";
export const LOG_LABELS =
  `${IS_DECADE} ? ` +
  "(datum.value >= 0.01 && datum.value <= 1000 ? format(datum.value, '~g') : " +
  "'1e' + format(round(log(datum.value) / LN10), 'd')) : ''";

/** A linear or logarithmic axis named by a quantity with its unit. */
export function quantity_axis(
  field,
  name,
  unit,
  { log = false, zero = false, domain, grid = true } = {},
) {
  return {
    field,
    type: "quantitative",
    scale: {
      type: log ? "log" : "linear",
      ...(log ? {} : { zero }),
      nice: domain === undefined,
      ...(domain ? { domain, clamp: true } : {}),
    },
    axis: {
      title: `${name_with_unit(name, unit)} `, // the space as in names.js
      grid,
      ...(log
        ? {
            labelExpr: LOG_LABELS,
            tickCount: 8,
            labelOverlap: true,
            gridOpacity: { condition: { test: IS_DECADE, value: 1 }, value: 0 },
          }
        : { tickCount: 6 }),
    },
  };
}

/**
 * An axis for values of both signs over many decades: linear up to the smallest, logarithmic beyond. For
 * `values` that need none, what quantity_axis() gives.
 */
export function signed_axis(field, name, unit, values, { domain }) {
  const axis = quantity_axis(field, name, unit, { domain });
  const sizes = values.map(Math.abs).filter((size) => size > 0);
  const smallest = sizes.reduce((a, b) => Math.min(a, b), Infinity);
  const largest = sizes.reduce((a, b) => Math.max(a, b), 0);
  if (!(largest / smallest >= 1e3)) return axis;
  // Every second decade from the largest down; the smallest stands too near to 0 for a label.
  const decades = [];
  for (let k = Math.floor(Math.log10(largest) + 1e-9); 10 ** k > smallest * (1 + 1e-9); k -= 2)
    decades.unshift(Number(`1e${k}`));
  const ticks = [...decades.map((value) => -value).reverse(), 0, ...decades];
  return {
    ...axis,
    scale: { ...axis.scale, type: "symlog", constant: smallest },
    axis: { ...axis.axis, values: ticks, format: "~r", labelOverlap: true },
  };
}

/** Whether a logarithmic axis says more: nothing negative and three decades or more between. */
export function wants_log(values) {
  let smallest = Infinity;
  let largest = 0;
  for (const value of values) {
    if (value < 0) return false;
    if (value > 0 && value < smallest) smallest = value;
    if (value > largest) largest = value;
  }
  return largest > 0 && largest / smallest >= 1e3;
}

/** The decades around the positive values, for a log axis on which zeros stand at the lower edge. */
export function log_domain(values) {
  const positive = values.filter((value) => value > 0 && Number.isFinite(value));
  const low = positive.reduce((a, b) => Math.min(a, b), Infinity);
  const high = positive.reduce((a, b) => Math.max(a, b), 0);
  if (high === 0) return [1e-16, 1];
  const decade = (value, round) => 10 ** round(Math.log10(value));
  const domain = [decade(low, Math.floor), decade(high, Math.ceil)];
  return domain[0] === domain[1] ? [domain[0] / 10, domain[1]] : domain;
}

/** Eight digits: all that a plot shows, half the bytes. */
export const rounded = (value) => (Number.isFinite(value) ? Number(value.toPrecision(8)) : null);
