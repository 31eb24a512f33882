// SPDX-License-Identifier: GPL-3.0-or-later
// Full records and plots of the page's parts, read when needed.
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

/** The plots of a family. */
export async function plots_of_family(name, index) {
  const place = index.families.findIndex((family) => family.name === name);
  return place >= 0 && index.families[place].plots.length > 0 ? json_of(`family/${place}`) : [];
}
