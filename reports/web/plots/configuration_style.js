// SPDX-License-Identifier: GPL-3.0-or-later
// How a configuration looks: the same colour, shape and dash in every plot, table and player of the page.
import {
  FIXED_POINT,
  NO_MEMORY,
  OLD,
  ordered_configurations,
  QUIET,
  SECANT,
} from "../model/configuration.js";
import { SERIES_DASHES, SERIES_SHAPES } from "./palette.js";

const style = (colour, place) => ({
  colour,
  shape: SERIES_SHAPES[place % SERIES_SHAPES.length],
  dash: SERIES_DASHES[place % SERIES_DASHES.length],
});

const OWN = new Map([
  [QUIET, style("$s0", 0)],
  [FIXED_POINT, style("$s1", 1)],
  [SECANT, style("$s3", 2)],
  [NO_MEMORY, style("$s4", 3)],
  [OLD, style("$s6", 4)],
]);
const FREE = ["$s2", "$s5", "$s3", "$s4", "$s1", "$s6"]; // of others, in this order

const others = []; // as they became known: a name keeps its place

/**
 * Tells the names of a page's configurations before anything is drawn, so that others than this project's
 * own look the same in plots that hold only some of them. A second call begins anew.
 */
export function know_configurations(names) {
  others.length = 0;
  others.push(...ordered_configurations(names).filter((name) => !OWN.has(name)));
}

const engines = []; // other engines, in the order of their names

/** The same for engines that stand side by side. A second call begins anew. */
export function know_engines(names) {
  engines.length = 0;
  engines.push(...[...new Set(names)].sort());
}

/** The place of an engine among those that are known; a new one comes last. */
export function place_of_engine(name) {
  if (!engines.includes(name)) engines.push(name);
  return engines.indexOf(name);
}

/** Map from each name to {colour: "$s0", shape, dash}; `colour` is a name of the palette's. */
export function configuration_styles(names) {
  for (const name of ordered_configurations(names))
    if (!OWN.has(name) && !others.includes(name)) others.push(name);
  return new Map(
    names.map((name) => {
      const place = others.indexOf(name);
      return [name, OWN.get(name) ?? style(FREE[place % FREE.length], OWN.size + place)];
    }),
  );
}

/**
 * The styles of a plot's variants, one for each of `configurations` (names, some of them the same): the
 * colour is the configuration's; from the second of the same on shape and dash are others.
 */
export function variant_styles(configurations) {
  const styles = configuration_styles(configurations);
  const taken = new Set([...styles.values()].map(({ shape }) => shape));
  const free = SERIES_SHAPES.map((_, place) => place).filter(
    (place) => !taken.has(SERIES_SHAPES[place]),
  );
  const seen = new Set();
  return configurations.map((name, i) => {
    const own = styles.get(name);
    if (!seen.has(name)) {
      seen.add(name);
      return own;
    }
    return style(own.colour, free.shift() ?? i);
  });
}
