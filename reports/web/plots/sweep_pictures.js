// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of a family's sweeps: who holds first, then what was measured, then what it cost.
import { sweeps_of } from "../model/sweep.js";
import { phase_diagram } from "./phase_diagram.js";
import { cost_maps } from "./sweep_cost.js";
import { cost_curves, value_curves } from "./sweep_curves.js";
import { sweep_layout } from "./sweep_layout.js";
import { value_maps } from "./sweep_values.js";

function pictures({ axes, series }) {
  if (axes.length === 0) return [];
  if (axes.length === 1) return [...value_curves(series, axes[0]), ...cost_curves(series, axes[0])];
  const all = series.reduce(
    (most, { records }) => (records.length > most.length ? records : most),
    [],
  );
  const layout = sweep_layout(all, axes);
  return [
    ...series.map(({ name, records }) => phase_diagram(name, records, layout)),
    ...value_maps(series, layout),
    ...cost_maps(series, layout),
  ];
}

/** `entries`, `name_of` and `series_of` as sweeps_of() takes them; none for records of no sweep. */
export const sweep_pictures = (entries, name_of, series_of) =>
  sweeps_of(entries, name_of, series_of).flatMap(pictures);
