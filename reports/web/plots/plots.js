// SPDX-License-Identifier: GPL-3.0-or-later
// Records → plots, for the page and for SVG files. A plot is
// {id, kind, title, caption, description, spec}; `spec` is Vega-Lite without colours and width.
import { group_by, short_name } from "../model/family.js";
import { attributes_of, variant_labels } from "../model/variant.js";
import { parameter_plot } from "./parameter_plot.js";
import { phase_plot } from "./phase_plot.js";
import { series_plot } from "./series_plot.js";
import { prediction_plot, threshold_plot } from "./threshold_plot.js";
import { trend_plots } from "./trend_plot.js";
import { work_precision_plot } from "./work_precision_plot.js";

const is_over_time = (series) => series.x_name === "time";
const is_over_runs = (series) => series.x_name === "run"; // as ./stiction track history writes it

const with_id = (plots, prefix) =>
  plots.filter(Boolean).map((plot, i) => ({ ...plot, id: `${prefix}/${plot.kind}-${i + 1}` }));

/**
 * The plots of one case. `entries`: [{record, run}] with `run` an index into `runs`; a run's name is
 * told only where runs are mixed.
 */
export function case_plots(case_name, entries, runs) {
  const labels = variant_labels(
    entries.map(({ record, run }) => attributes_of(record, runs[run].short)),
  );
  const labelled = entries.map(({ record }, i) => ({ record, label: labels[i] }));
  const curves = labelled
    .flatMap(({ record, label }) => record.series.map((series) => ({ label, series })))
    .filter(({ series }) => series.x.length > 0);
  const same_axes = group_by(curves, ({ series }) =>
    JSON.stringify([series.name, series.unit, series.x_name, series.x_unit]),
  );
  const series_plots = [...same_axes.values()].map((group) =>
    is_over_time(group[0].series)
      ? { kind: "series", ...series_plot(group) }
      : is_over_runs(group[0].series)
        ? { kind: "trend", ...series_plot(group) }
        : parameter_plot(group),
  );
  const phases = phase_plot(labelled);
  return with_id([...series_plots, phases && { kind: "phases", ...phases }], case_name);
}

/** The plots of one family, over all its cases. */
export function family_plots(family, entries, runs) {
  const current = entries.filter(({ run }) => runs[run].role === "shown");
  const variants = variant_labels(
    current.map(({ record, run }) => attributes_of(record, runs[run].short)),
    (i) => current[i].record.case,
  );
  const of_case = group_by(current, ({ record }) => record.case);
  const described = current.map(({ record }, i) => ({
    record,
    variant: variants[i],
    label: [short_name(record.case), of_case.get(record.case).length > 1 && variants[i]]
      .filter(Boolean)
      .join("  "),
  }));
  const threshold = threshold_plot(described);
  const prediction = prediction_plot(described);
  const work = work_precision_plot(described);
  return with_id(
    [
      threshold && { kind: "threshold", ...threshold },
      prediction && { kind: "prediction", ...prediction },
      work && { kind: "work-precision", ...work },
      ...trend_plots(entries, runs),
    ],
    family,
  );
}
