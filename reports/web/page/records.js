// SPDX-License-Identifier: GPL-3.0-or-later
// Full records and plots of the page's parts, read when needed.
import { is_map } from "../model/map_kind.js";
import { json_of } from "./asset.js";

/** The records of a case, with `run`, from the rows of the index that name it. */
export async function records_of_case(name, rows) {
  const part = rows.find((row) => row.case === name)?.part;
  if (part === undefined) return [];
  return (await json_of(`records/${part}`)).filter((record) => record.case === name);
}

/** The plots of a case; null when they were left out for the page's size. */
export async function plots_of_case(name, rows, index) {
  const part = rows.find((row) => row.case === name)?.part;
  const asset = `plots/${part}`;
  if (!index.assets.includes(asset)) return null;
  return (await json_of(asset)).find((one) => one.case === name)?.plots ?? [];
}

/** The plots of a family, in their order; with `maps: false` those that are read at once. */
export async function plots_of_family(name, index, { maps = true } = {}) {
  const place = index.families.findIndex((family) => family.name === name);
  const all = index.families[place]?.plots ?? [];
  const [first, later] = await Promise.all([
    all.some((plot) => !is_map(plot)) ? json_of(`family/${place}`) : [],
    maps && all.some(is_map) ? json_of(`family/${place}/maps`) : [],
  ]);
  const by_id = new Map([...first, ...later].map((plot) => [plot.id, plot]));
  return all.map(({ id }) => by_id.get(id)).filter(Boolean);
}
