// SPDX-License-Identifier: GPL-3.0-or-later
import { join } from "node:path";
import { make_folder, write_whole } from "./files.mjs";
import { svg_of, svg_width } from "../plots/draw.js";

// A plot's id as a file name: letters that every file system takes, and short.
const file_name = (id) => `${id.replace(/[^\w.=-]+/g, "_").slice(0, 120)}.svg`;

/** Writes each plot of the page as an SVG file; gives how many. */
export async function write_svg_files(folder, data) {
  make_folder(folder);
  const plots = [
    ...[data.index.summary?.work, data.index.summary?.slip].filter(Boolean),
    ...(data.index.compared?.scores ?? []).flatMap(({ plots: list }) => list),
    ...data.families.flatMap(({ plots: list }) => list),
    ...(data.comparison?.plots ?? []),
  ];
  for (const part of data.parts) for (const { plots: list } of part.plots()) plots.push(...list);
  const taken = new Set();
  for (const plot of plots) {
    let name = file_name(plot.id);
    for (let i = 2; taken.has(name.toLowerCase()); ++i)
      name = file_name(plot.id).replace(/\.svg$/, `-${i}.svg`);
    taken.add(name.toLowerCase());
    write_whole(
      join(folder, name),
      await svg_of({ title: plot.title, ...plot.spec }, "light", svg_width(plot)),
    );
  }
  return plots.length;
}
