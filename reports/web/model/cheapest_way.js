// SPDX-License-Identifier: GPL-3.0-or-later
// The cheapest way to an error below a bound, as cheapest_ways() in
// validation/comparison/engines/engine_matrix.h: of the other engines, and of ours. Other builds of ours
// are neither.
import { is_of_others, OURS } from "./engine.js";
import { machines_of } from "./machine.js";
import { to_number } from "./number.js";

export const BOUNDS = [1e-2, 1e-4, 1e-6];

/** All points of the curves of `told`, [{name, record}]: [{name, engine, others, seconds, error}]. */
export const points_of = (told) =>
  told.flatMap(({ name, record }) =>
    record.series.slice(0, 1).flatMap(({ x, y }) =>
      x.map((seconds, i) => ({
        name,
        engine: record.engine,
        others: is_of_others(record),
        seconds: to_number(seconds),
        error: to_number(y[i]),
      })),
    ),
  );

function cheapest(points, bound) {
  const there = points.filter(({ error, seconds }) => error <= bound && seconds > 0);
  return there.reduce((a, b) => (a === null || b.seconds < a.seconds ? b : a), null);
}

/**
 * [{bounds, theirs, ours, ratio}], bounds with the same ways in one; a way is {name, seconds} or null.
 * `ratio` is how many times as much ours costs, null where there is nothing to compare.
 */
export function cheapest_ways(points) {
  const short = (point) => point && { name: point.name, seconds: point.seconds };
  const ways = BOUNDS.map((bound) => ({
    bound,
    theirs: cheapest(
      points.filter(({ others }) => others),
      bound,
    ),
    ours: cheapest(
      points.filter(({ engine }) => engine === OURS),
      bound,
    ),
  }));
  const rows = [];
  for (const { bound, theirs, ours } of ways) {
    const last = rows.at(-1);
    if (last && last.theirs === theirs && last.ours === ours) last.bounds.push(bound);
    else rows.push({ bounds: [bound], theirs, ours });
  }
  return rows.map((row) => ({
    bounds: row.bounds,
    theirs: short(row.theirs),
    ours: short(row.ours),
    ratio: row.theirs && row.ours ? row.ours.seconds / row.theirs.seconds : null,
  }));
}

/**
 * The cheapest ways of `told`, [{name, record}], one a machine: timings of two don't compare. [{machine, ways}];
 * `machine` is its letter, "" where there is one.
 */
export function cheapest_by_machine(told) {
  const machines = machines_of(told.map(({ record }) => record));
  return machines.map(({ letter, records }) => ({
    machine: machines.length > 1 ? letter : "",
    ways: cheapest_ways(points_of(told.filter(({ record }) => records.includes(record)))),
  }));
}
