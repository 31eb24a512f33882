// SPDX-License-Identifier: GPL-3.0-or-later
// Runs → what the page holds: an index that is read at once, and parts that are read when needed.
import { compare, noises_of, same_reason } from "../model/compare.js";
import { column_names } from "../model/column_name.js";
import { configuration_of, ordered_configurations } from "../model/configuration.js";
import {
  ENGINE_FINDINGS,
  is_of_engines,
  is_of_others,
  own_labels,
  record_labels,
} from "../model/engine.js";
import { family_name, group_by } from "../model/family.js";
import { is_comparison } from "../model/figure.js";
import { is_findings } from "../model/finding.js";
import { fingerprints_of, know_machines, machine_letters } from "../model/machine.js";
import { natural_sort } from "../model/natural.js";
import { to_number } from "../model/number.js";
import { VERDICTS } from "../model/verdict.js";
import { variant_key } from "../model/variant.js";
import { comparison_plots } from "../plots/comparison_plot.js";
import { know_configurations, know_engines } from "../plots/configuration_style.js";
import { case_plots, family_plots } from "../plots/plots.js";
import { compared_of } from "./compared.mjs";
import { environments_of } from "./environments.mjs";
import { engines_of, with_whole_questions } from "./engines.mjs";
import { row_of, short_number, Texts } from "./index_row.mjs";
import { run_heads } from "./run_heads.mjs";
import { stability_counts, stability_of } from "./stability.mjs";
import { summary_of } from "./summary.mjs";

const RECORDS_A_PART = 200;
const MOST_CHANGES = 5000;

// What the configurations are called, in the cases and in the summary.
const names_of = (records) => [
  ...records.map(configuration_of),
  ...records.filter((record) => !is_of_engines(record)).map(column_names(records)),
];

// Entries in parts of about the same size; a case is never split.
function parts_of(by_case) {
  const parts = [];
  let part = [];
  let size = 0;
  for (const entry of by_case) {
    part.push(entry);
    size += entry[1].length;
    if (size >= RECORDS_A_PART) {
      parts.push(part);
      part = [];
      size = 0;
    }
  }
  if (part.length > 0) parts.push(part);
  return parts;
}

/**
 * {index, parts, families, comparison}: JSON values. `parts[i]` gives the records and the plots of some
 * cases when it is called, so that one part at a time is in memory.
 */
export function page_data({ runs, against, title, warnings }) {
  const heads = run_heads(runs, against);
  const all = [...runs, ...against].flatMap((run, place) =>
    with_whole_questions(run.records).map((record) => ({ record, run: place })),
  );
  // Findings stand on the summary; they are no case.
  const entries = all.filter(({ record }) => !is_findings(record));
  const findings = all
    .filter(({ record, run }) => is_findings(record) && heads[run].role === "shown")
    .map(({ record, run }) => ({
      run,
      notes: record.notes,
      of_engines: record.case === ENGINE_FINDINGS,
    }));
  const names = natural_sort(
    [...new Set(entries.map(({ record }) => record.case))],
    (name) => name,
  );
  const groups = group_by(entries, ({ record }) => record.case);
  const by_case = names.map((name) => [name, groups.get(name)]);
  const cut = parts_of(by_case);

  const configurations = ordered_configurations(names_of(entries.map(({ record }) => record)));
  know_configurations(configurations);
  const machines = fingerprints_of(entries.map(({ record }) => record));
  know_machines(machines);
  know_engines(
    entries
      .filter(({ record }) => is_of_engines(record) && is_of_others(record))
      .map(({ record }) => record.engine),
  );
  const texts = new Texts();
  const rows = [];
  cut.forEach((part, place) => {
    for (const [, group] of part) {
      const labels = own_labels(group.map(({ record }) => record));
      group.forEach(({ record, run }, i) =>
        rows.push(row_of(texts, { record, run, part: place, label: labels[i] })),
      );
    }
  });

  const shown = entries.filter(({ run }) => heads[run].role === "shown");
  // Engines have a table of their own; what else there is, is judged as ever.
  const engines = engines_of(shown, heads);
  const current = shown.filter(({ record }) => !is_of_engines(record));
  const name_of = column_names(current.map(({ record }) => record));
  const several = new Set(current.map(({ run }) => run)).size > 1;
  const series_of = ({ record, run }) =>
    several ? `${name_of(record)} · ${heads[run].short}` : name_of(record);
  const stability = stability_of(current, name_of, series_of);
  const by_family = [...group_by(by_case, ([name]) => family_name(name))];
  const families = by_family.map(([name, cases]) => ({
    name,
    plots: family_plots(
      name,
      cases.flatMap(([, group]) => group),
      heads,
      { name_of, series_of },
    ),
  }));
  const changes =
    against.length > 0
      ? compare(
          against.flatMap(({ records }) => records),
          runs.flatMap(({ records }) => records),
        )
      : null;
  const counts = Object.fromEntries(VERDICTS.map((verdict) => [verdict, 0]));
  for (const { record } of current.length > 0 ? current : shown)
    for (const { verdict } of record.checks) ++counts[verdict];

  // Where rules stand side by side, margins say nothing: all that is judged is yes or no.
  const in_order = natural_sort([...current], ({ record }) => record.case);
  const compared = is_comparison(current.map(({ record }) => record))
    ? compared_of(in_order, heads)
    : null;
  const summary = compared ? null : summary_of(current.map(({ record }) => record));
  return {
    index: {
      title,
      runs: heads,
      warnings,
      check_counts: counts,
      compared,
      findings: findings.filter(({ of_engines }) => !of_engines),
      engines: engines && {
        ...engines,
        findings: findings.filter(({ of_engines }) => of_engines),
      },
      summary,
      stability: stability && stability_counts(stability),
      configurations,
      machines,
      environments: environments_of(all, heads),
      families: families.map(({ name, plots }) => ({
        name,
        plots: plots.map(({ id, kind, title: plot_title }) => ({ id, kind, title: plot_title })),
      })),
      rows,
      texts: texts.list,
    },
    parts: cut.map((part) => ({
      records: () =>
        part.flatMap(([, group]) =>
          group.map(({ record, run }) => ({ ...without_series(record), run })),
        ),
      plots: () =>
        part.map(([name, group]) => ({ case: name, plots: case_plots(name, group, heads) })),
    })),
    families,
    stability,
    comparison: changes && {
      total: changes.length,
      counts: Object.fromEntries(
        [...group_by(changes, (change) => change.class)].map(([name, list]) => [name, list.length]),
      ),
      unchanged: unchanged_of(changes),
      noises: told_noises(changes),
      changes: thin_changes(changes.slice(0, MOST_CHANGES)),
      plots: comparison_plots(
        changes
          .filter(is_beyond_noise)
          .map((change) => ({ ...change, family: family_name(change.case) })),
      ).map((plot, i) => ({ ...plot, id: `comparison/${i + 1}` })),
      seconds: cost_sums(changes),
    },
  };
}

// The series stand in the plots' data already.
function without_series(record) {
  const { series, ...rest } = record;
  return rest;
}

function told_noises(changes) {
  const noises = noises_of(changes);
  const letters = machine_letters(both_of(changes));
  return noises.map(({ before, after, across, ...noise }) => ({
    ...noise,
    machines: noises.length > 1 || across ? [letters([before]), letters([after])] : null,
  }));
}

const both_of = (changes) =>
  changes.flatMap(({ before, after }) => [before, after]).filter(Boolean);

function thin_changes(changes) {
  const letters = machine_letters(both_of(changes));
  const thin = (record) =>
    record && {
      machine: letters([record]),
      verdict: record.verdict,
      seconds: short_number(to_number(record.cost.cpu_seconds)),
    };
  const records = changes.map(({ before, after }) => after ?? before);
  // Of each case as little as tells its records apart; the configuration where one is alone.
  const labels = new Map();
  for (const group of group_by(records, (record) => record.case).values())
    record_labels(group, () => "").forEach((label, i) =>
      labels.set(group[i], label || configuration_of(group[i])),
    );
  return changes.map(({ before, after, ...rest }, i) => ({
    ...rest,
    before: thin(before),
    after: thin(after),
    variant: variant_key(records[i]),
    label: labels.get(records[i]),
  }));
}

const is_beyond_noise = ({ class: name }) => name !== "same";

// How many changed by no more than noise, and why they count as unchanged; how many were too short to time.
function unchanged_of(changes) {
  const same = changes.filter((change) => !is_beyond_noise(change));
  return {
    by_reason: Object.fromEntries(
      [...group_by(same, same_reason)].map(([reason, list]) => [reason, list.length]),
    ),
    untimed: same.filter(({ timed, across }) => !timed && !across).length,
    moved: same.filter(({ timed, across }) => !timed && across).length,
  };
}

function cost_sums(changes) {
  const paired = changes.filter(({ before, after }) => before && after);
  const sum = (side) =>
    paired.reduce((total, change) => total + to_number(change[side].cost.cpu_seconds), 0);
  return { before: sum("before"), after: sum("after") };
}
