// SPDX-License-Identifier: GPL-3.0-or-later
// Records → plots, for the page and for SVG files. A plot is
// {id, kind, title, caption, description, spec}; `spec` is Vega-Lite without colours and width.
import { group_by, short_name } from "../model/family.js";
import { configuration_of } from "../model/configuration.js";
import { compared_variants, is_answer, is_engine_case, record_labels } from "../model/engine.js";
import { is_comparison } from "../model/figure.js";
import { engine_work_plot } from "./engine_work_plot.js";
import { ladder_plots } from "./ladder_plot.js";
import { history_plots, is_history } from "./history_plot.js";
import { is_timing, plot_by_machine, variants_by_machine, with_timings } from "./machine_marks.js";
import { parameter_plot } from "./parameter_plot.js";
import { phase_plot } from "./phase_plot.js";
import { is_rule_work, rule_work_plots } from "./rule_work_plot.js";
import { run_plot } from "./run_plot.js";
import { score_plots } from "./score_plot.js";
import { series_plot } from "./series_plot.js";
import { sweep_pictures } from "./sweep_pictures.js";
import { sweep_plots } from "./sweep_plot.js";
import { prediction_plot, threshold_plot } from "./threshold_plot.js";
import { trend_plots } from "./trend_plot.js";
import { work_precision_plot } from "./work_precision_plot.js";

const is_over_time = (series) => series.x_name === "time";
const is_over_runs = (series) => series.x_name === "run"; // as ./stiction track history writes it

const with_id = (plots, prefix) =>
  plots.filter(Boolean).map((plot, i) => ({ ...plot, id: `${prefix}/${plot.kind}-${i + 1}` }));

/** Entries as rules on contacts or as engines; the run is named where several are mixed. */
export function variants_of(entries, runs) {
  const several = new Set(entries.map(({ run }) => run)).size > 1;
  return compared_variants(
    entries.map(({ record }) => record),
    (i) => (several ? runs[entries[i].run].short : ""),
  );
}

// Earlier runs stand in the view that compares runs; here 28 curves are enough.
const shown_of = (entries, runs) => {
  const shown = entries.filter(({ run }) => runs[run].role === "shown");
  return shown.length > 0 ? shown : entries;
};

function comparison_case_plots(entries, runs) {
  const variants = variants_of(entries, runs);
  const curves = entries
    .flatMap(({ record }, i) =>
      record.series.map((series) => ({ variant: variants[i], series, record })),
    )
    .filter(({ series }) => series.x.length > 0);
  const same_axes = group_by(curves, ({ series }) => axes_key(series));
  return [...same_axes.values()].flatMap((group) =>
    is_history(group[0].series) ? history_plots(group) : sweep_plots(group),
  );
}

/** The pictures over all cases of a comparison: [{folder, plots}]. */
export function comparison_scores(entries, runs) {
  const variants = variants_of(entries, runs);
  return score_plots(entries.map(({ record }, i) => ({ record, variant: variants[i] })));
}

const axes_key = (series) =>
  JSON.stringify([series.name, series.unit, series.x_name, series.x_unit]);

/**
 * The plots of one case. `entries`: [{record, run}] with `run` an index into `runs`; a run's name is
 * told only where runs are mixed.
 */
export function case_plots(case_name, entries, runs) {
  if (is_engine_case(case_name)) return []; // its family, which has no other case, has them
  if (is_comparison(entries.map(({ record }) => record)))
    return with_id(comparison_case_plots(shown_of(entries, runs), runs), case_name);
  const labels = record_labels(
    entries.map(({ record }) => record),
    (i) => runs[entries[i].run].short,
  );
  const labelled = entries.map(({ record }, i) => ({
    record,
    label: labels[i],
    configuration: configuration_of(record),
  }));
  const curves = labelled
    .flatMap((entry) => entry.record.series.map((series) => ({ ...entry, series })))
    .filter(({ series }) => series.x.length > 0);
  const same_axes = group_by(curves, ({ series }) => axes_key(series));
  const plot_of = (group) =>
    is_over_time(group[0].series)
      ? { kind: "series", ...series_plot(group) }
      : is_over_runs(group[0].series)
        ? run_plot(group)
        : parameter_plot(group);
  const series_plots = [...same_axes.values()].map((group) =>
    is_timing(group[0].series) ? plot_by_machine(group, plot_of) : plot_of(group),
  );
  // Phases of different engines are not the same.
  const phases = entries.every(({ record }) => is_answer(record))
    ? null
    : plot_by_machine(labelled, phase_plot);
  return with_id([...series_plots, phases && { kind: "phases", ...phases }], case_name);
}

// Of a history: times, and digits of what its cases check, each in one picture.
function run_plots(described) {
  const curves = described.flatMap((entry) =>
    entry.record.series.filter(is_over_runs).map((series) => ({ ...entry, series })),
  );
  const times = curves.filter(({ series }) => series.name === "time");
  const digits = curves
    .filter(({ series }) => series.name.startsWith("digits: "))
    .map(({ label, series, ...entry }) => ({
      ...entry,
      label: `${label}  ${series.name.slice("digits: ".length)}`,
      series: { ...series, name: "digits" },
    }));
  return [
    times.length > 0 && plot_by_machine(times, run_plot),
    digits.length > 0 && run_plot(digits),
  ].filter(Boolean);
}

/**
 * The plots of one family, over all its cases. `name_of(record)` is what its configuration is called beside
 * those of all families, `series_of(entry)` the same with its run.
 */
export function family_plots(
  family,
  entries,
  runs,
  { name_of = configuration_of, series_of = ({ record }) => name_of(record) } = {},
) {
  const current = entries.filter(({ run }) => runs[run].role === "shown");
  const records = current.map(({ record }) => record);
  if (is_engine_case(family)) {
    const variants = variants_of(current, runs);
    return with_id(
      [
        with_timings(
          engine_work_plot(
            variants_by_machine(records.map((record, i) => ({ record, variant: variants[i] }))),
          ),
          records,
        ),
      ],
      family,
    );
  }
  if (is_comparison(records)) {
    const variants = variants_of(current, runs);
    const work = is_rule_work(records)
      ? rule_work_plots(
          variants_by_machine(records.map((record, i) => ({ record, variant: variants[i] }))),
        ).map((plot) => with_timings(plot, records))
      : [];
    return with_id(
      [...work.map((plot) => ({ kind: "work-precision", ...plot })), ...trend_plots(entries, runs)],
      family,
    );
  }
  const variants = record_labels(
    records,
    (i) => runs[current[i].run].short,
    (i) => current[i].record.case,
  );
  const of_case = group_by(current, ({ record }) => record.case);
  const described = current.map(({ record }, i) => ({
    record,
    configuration: configuration_of(record),
    label: [short_name(record.case), of_case.get(record.case).length > 1 && variants[i]]
      .filter(Boolean)
      .join("  "),
  }));
  const threshold = threshold_plot(described);
  const prediction = prediction_plot(described);
  // Of engines each question has a curve of its own.
  const work = records.some(is_answer) ? null : work_precision_plot(records);
  return with_id(
    [
      ...sweep_pictures(current, name_of, series_of),
      ...ladder_plots(current, name_of, series_of),
      threshold && { kind: "threshold", ...threshold },
      prediction && { kind: "prediction", ...prediction },
      work && { kind: "work-precision", ...work },
      ...run_plots(described),
      ...trend_plots(entries, runs),
    ],
    family,
  );
}
