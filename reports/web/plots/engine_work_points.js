// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the picture of engines' work and precision: points, failures, and how each engine looks.
import { build_of, OURS } from "../model/engine.js";
import { failed_efforts } from "../model/engine_answer.js";
import { machine_letter } from "../model/machine.js";
import { to_number } from "../model/number.js";
import { place_of_engine } from "./configuration_style.js";
import { SERIES_COLOURS, SERIES_SHAPES } from "./palette.js";

const OTHER_SHAPES = 3;
const MOST_FAILED = 9; // named in the plot
const LINE = 14; // px from name to name

const is_ours = ({ variant, record }) => variant.rule === OURS || build_of(record) === OURS;

/**
 * [{color, shape}] of some entries: a colour for each engine, ink for ours and other builds of it, a shape
 * for each of its configurations. When the colours begin again, they do so with other shapes.
 */
export function looks_of(entries) {
  const seen = new Map();
  return entries.map((entry) => {
    const { rule } = entry.variant;
    const ours = is_ours(entry);
    const key = ours ? OURS : rule;
    const place = seen.get(key) ?? 0;
    seen.set(key, place + 1);
    const engine = ours ? 0 : place_of_engine(rule);
    const colour = engine % SERIES_COLOURS.length;
    const round = Math.floor(engine / SERIES_COLOURS.length);
    return {
      color: ours ? "$ink" : SERIES_COLOURS[colour],
      shape: SERIES_SHAPES[(place + OTHER_SHAPES * round) % SERIES_SHAPES.length],
    };
  });
}

/** An engine's points; its curve has the efforts that did not fail, in order. `key` is its number. */
export function points_of({ variant, record }, key) {
  const { x, y } = record.series[0] ?? { x: [], y: [] };
  const failed = new Set(failed_efforts(record).map(({ effort }) => effort));
  let effort = -1;
  return x.map((seconds, i) => {
    do ++effort;
    while (failed.has(effort));
    return {
      who: variant.name,
      who_key: key,
      machine: machine_letter(record),
      effort,
      ours: is_ours({ variant, record }),
      build: build_of(record) !== "",
      seconds: to_number(seconds),
      error: to_number(y[i]),
    };
  });
}

/** What failed, as lines in the upper right corner. */
export function failed_lines(entries) {
  const words = entries.flatMap(({ variant, record }, key) =>
    failed_efforts(record).map(({ effort, reason }) => ({
      who: variant.name,
      who_key: key,
      name: `✕ ${variant.name}, effort ${effort}`,
      failure: reason,
    })),
  );
  const shown = words.length > MOST_FAILED ? words.slice(0, MOST_FAILED - 1) : words;
  const more = words.length - shown.length;
  const rest = { who: "", who_key: 0, name: `✕ and ${more} more, listed below`, failure: "" };
  return (more > 0 ? [...shown, rest] : shown).map((one, i) => ({
    ...one,
    place: LINE * (i + 0.5),
  }));
}
