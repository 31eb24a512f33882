// SPDX-License-Identifier: GPL-3.0-or-later
// How the points of a sweep lie on a page: two axes are one panel; a third one on a grid gives a small panel for
// each of its values; what has more axes or values, or is scattered, gives a panel for each pair of axes.
import { axis_value, is_scattered } from "../model/sweep.js";
import { rounded } from "./axes.js";

export const HEIGHT = 360; // px, of one panel
const WIDTH = 600; // px, about
const PANEL = 190; // px, about, of each of several
const MOST_FACETS = 12;
const MOST_PAIRED = 6; // axes, which make 15 pairs
const MOST_MARKS = 20_000;

const pairs_of = (axes) => axes.flatMap((across, i) => axes.slice(i + 1).map((up) => [across, up]));

function split(axes, scattered) {
  if (axes.length === 2) return { facet: null, pairs: [axes] };
  if (axes.length === 3 && !scattered) {
    const facet = axes.reduce((a, b) => (b.values.length <= a.values.length ? b : a));
    if (facet.values.length <= MOST_FACETS)
      return { facet, pairs: [axes.filter((axis) => axis !== facet)] };
  }
  return { facet: null, pairs: pairs_of(axes.slice(0, MOST_PAIRED)) };
}

/**
 * How `records`, points of a sweep that varies `axes`, are laid out: {axes, facet, pairs, panels, scattered,
 * cells, left_out}. Each of the axes that are shown has the `field` of the data where its value is; `cells`:
 * whether each panel has each of its points once, so that they can be rectangles that touch.
 */
export function sweep_layout(records, axes) {
  const scattered = is_scattered(records, axes);
  const { facet, pairs } = split(axes, scattered);
  const single = pairs.length === 1;
  const fields = single ? ["x", "y"] : axes.map((_, i) => `axis_${i}`);
  const shown = [...new Set(pairs.flat())].map((axis, i) => ({ ...axis, field: fields[i] }));
  const named = (axis) => shown.find(({ name }) => name === axis.name);
  return {
    axes: shown,
    facet: facet && { ...facet, field: "facet" },
    pairs: pairs.map((pair) => pair.map(named)),
    panels: facet ? facet.values.length : pairs.length,
    scattered,
    cells: single && !scattered,
    left_out: axes.length - shown.length - (facet ? 1 : 0),
  };
}

/** "a and b", "a and b, by c", "pairs of a, b, c and d". */
export function over_words({ axes, facet }) {
  const names = axes.map(({ name }) => name);
  const list = `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`;
  if (axes.length > 2) return `pairs of ${list}`;
  return facet ? `${list}, by ${facet.name}` : list;
}

const ENDS = ["th", "st", "nd", "rd"];
const ordinal = (n) => `${n}${(n % 100 > 10 && n % 100 < 14 ? "th" : ENDS[n % 10]) ?? "th"}`;

/** {shown, words}: as many records as can be drawn, evenly chosen, and what a caption says of that. */
export function drawn_of({ pairs, left_out, axes }, records) {
  const every = Math.ceil((records.length * pairs.length) / MOST_MARKS);
  return {
    shown: every > 1 ? records.filter((_, i) => (records.length - 1 - i) % every === 0) : records,
    words: [
      every > 1 && `every ${ordinal(every)} point is drawn`,
      left_out > 0 && `the first ${axes.length} axes are drawn, ${left_out} more are not`,
    ]
      .filter(Boolean)
      .join("; "),
  };
}

/** The data of a record's place: what the axes read, and the case that a click opens. None where one is no number. */
export function sweep_place({ axes, facet }, record) {
  const place = { case: record.case };
  for (const { name, field } of axes) place[field] = rounded(axis_value(record, name));
  if (facet) {
    place[facet.field] = rounded(axis_value(record, facet.name));
    place.facet_key = facet.values.indexOf(axis_value(record, facet.name));
  }
  const fields = [...axes, ...(facet ? [facet] : [])].map(({ field }) => field);
  return fields.every((field) => Number.isFinite(place[field])) ? place : null;
}

/**
 * What marks of a sweep have in common. Not one of their places or colours is missing: Vega-Lite, which would look for
 * that, would take a third of the time that their picture does.
 */
export const SWEEP_MARK = { invalid: "show", cursor: "pointer" };

/** Area of marks that fit beside each other, px². */
export function mark_size({ pairs, panels, scattered }, count) {
  const [across, up] = panels > 1 ? [PANEL, PANEL] : [WIDTH, HEIGHT];
  const side = scattered
    ? Math.sqrt((across * up) / count)
    : Math.min(...pairs.map(([x, y]) => Math.min(across / x.values.length, up / y.values.length)));
  return Math.round(Math.min(panels > 1 ? 50 : 160, Math.max(6, (0.62 * side) ** 2)));
}
