// SPDX-License-Identifier: GPL-3.0-or-later
// The axes of a ladder in decades: of its parameter, where zero and what is negative stand left of a gap, and
// of error ÷ tolerance, where an exact zero stands at the floor and what has no end at the ceiling.
import { rounded } from "./axes.js";
import { labelled } from "./names.js";

const GAP = 0.1; // of the decades shown, around zero
const MOST_TICKS = 60;
const LEAST = -16; // decades: below a double's rounding a ratio says no more
const MOST = 6;
const TICKS = 6;

// As many of some as can be drawn, from the first to the last.
const thinned = (all) => {
  const step = Math.ceil(all.length / MOST_TICKS);
  return all.filter((_, i) => i % step === 0);
};

/**
 * {place_of(value), domain, ticks, gap}: `values` are the parameter's, with `text_of` as they are spelled;
 * `gap` is where zero and what is negative end, null where there are none.
 */
export function parameter_places(values, text_of) {
  const sizes = (sign) => values.map((value) => sign * value).filter((size) => size > 0);
  const decades = (list) => list.map(Math.log10);
  const least = (list) => list.reduce((a, b) => Math.min(a, b), Infinity);
  const most = (list) => list.reduce((a, b) => Math.max(a, b), -Infinity);
  const [positive, negative] = [decades(sizes(1)), decades(sizes(-1))];
  const span = (list) => (list.length > 0 ? most(list) - least(list) : 0);
  const gap = Math.max(0.3, GAP * (span(positive) + span(negative)));
  const zero = positive.length > 0 ? least(positive) - gap : 0;
  const place_of = (value) => {
    if (value > 0) return rounded(Math.log10(value));
    if (value === 0) return rounded(zero);
    return rounded(zero - gap - (Math.log10(-value) - least(negative)));
  };
  const unique = [...new Set(values)].sort((a, b) => a - b);
  const places = unique.map(place_of);
  const room = Math.max(0.15, 0.04 * (places.at(-1) - places[0]));
  const shown = thinned(unique);
  return {
    place_of,
    domain: [places[0] - room, places.at(-1) + room],
    ticks: labelled(shown.map(place_of), shown.map(text_of)),
    gap: positive.length > 0 && positive.length < values.length ? zero + gap / 2 : null,
  };
}

/** {place_of(ratio), floor, ceiling, tolerance: 0, ticks}: in decades, clamped; infinite ones at `ceiling`. */
export function ratio_places(ratios) {
  const finite = ratios.filter((ratio) => ratio > 0 && ratio < Infinity).map(Math.log10);
  const clamp = (value, low, high) => Math.min(high, Math.max(low, value));
  const low = clamp(Math.floor(finite.reduce((a, b) => Math.min(a, b), -1)), LEAST, -1);
  const high = clamp(Math.ceil(finite.reduce((a, b) => Math.max(a, b), 1)), 1, MOST);
  const step = Math.ceil((high - low) / TICKS);
  const floor = ratios.includes(0) ? low - step : low;
  const endless = ratios.includes(Infinity);
  const ceiling = endless ? high + step : high;
  const decades = [];
  for (let k = Math.ceil(low / step) * step; k <= high; k += step) decades.push(k + 0); // no −0
  const text_of = (decade) => (decade === 0 ? "1" : `1e${decade}`);
  const places = [...(floor < low ? [floor] : []), ...decades, ...(endless ? [ceiling] : [])];
  const texts = [...(floor < low ? ["0"] : []), ...decades.map(text_of), ...(endless ? ["∞"] : [])];
  return {
    place_of: (ratio) => {
      if (ratio === Infinity) return ceiling;
      return ratio === 0 ? floor : rounded(clamp(Math.log10(ratio), low, high));
    },
    floor: floor - 0.4 * step,
    ceiling: ceiling + 0.5 * step,
    strip: endless ? ceiling - 0.5 * step : null,
    ticks: labelled(places, texts),
  };
}
