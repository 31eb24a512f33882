// SPDX-License-Identifier: GPL-3.0-or-later
// Timings in plots: what ran on several machines is several series, named with its machine, and the caption says
// which machines these are.
import { group_by } from "../model/family.js";
import { machine_names, timings_sentence } from "../model/machine.js";
import { pareto_front } from "./fit.js";
import { kind_of } from "./parameter_plot.js";

const TIME_UNITS = ["s", "ms", "µs", "ns"];

/** Whether a series tells how long something took to compute. */
export const is_timing = (series) =>
  TIME_UNITS.includes(series.unit) && (series.x_name === "run" || kind_of(series) === "scaling");

/** A plot of the timings of `records`, with their machines in its caption where there are several. */
export const with_timings = (plot, records) =>
  plot && {
    ...plot,
    caption: [plot.caption, timings_sentence(records)].filter(Boolean).join(" "),
  };

/** The Pareto fronts of `points`, each with its `machine`, one a machine: timings of two don't compare. */
export const fronts_by_machine = (points, cost_of, error_of) =>
  [...group_by(points, ({ machine }) => machine).values()].flatMap((own) =>
    pareto_front(own, cost_of, error_of),
  );

/** Keeps the lines of different machines' fronts apart. */
export const BY_MACHINE = { field: "machine" };

const records_of = (entries) => entries.map(({ record }) => record);

/** `plot_of(entries)`, [{label, record, …}], with each label naming its machine where there are several. */
export function plot_by_machine(entries, plot_of) {
  const named = machine_names(records_of(entries));
  const told = entries.map((entry) => ({ ...entry, label: named(entry.label, entry.record) }));
  return with_timings(plot_of(told), records_of(entries));
}

/** Entries [{record, variant}] whose variants' names name their machines where there are several. */
export function variants_by_machine(entries) {
  const named = machine_names(records_of(entries));
  return entries.map(({ variant, ...entry }) => ({
    ...entry,
    variant: { ...variant, name: named(variant.name, entry.record) },
  }));
}
