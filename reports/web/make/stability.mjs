// SPDX-License-Identifier: GPL-3.0-or-later
// How many digits survive, and where it breaks: of each engine and configuration a table perturbed case ×
// perturbation, and of each ladder how far it holds.
import { margin, margin_text } from "../model/check_text.js";
import { ordered_configurations } from "../model/configuration.js";
import { family_name, group_by } from "../model/family.js";
import { deciding_check, holds, is_ladder, rung_of, span_of, worse_of } from "../model/ladder.js";
import { natural_sort } from "../model/natural.js";
import { to_number } from "../model/number.js";
import { groups_of, is_perturbed, lacking_of, perturbation_of } from "../model/perturbation.js";
import { exact_command, perturbed_command } from "../model/rerun.js";
import { short_number } from "./index_row.mjs";

const number = (value) => short_number(to_number(value));

// One check in the table; `command` reruns the perturbation that its worst figure is of.
function cell_of(record, check) {
  const perturbation = perturbation_of(check);
  return {
    verdict: check.verdict,
    value: number(check.value),
    digits: check.digits === undefined ? null : number(check.digits),
    tolerance: number(check.tolerance),
    worst: check.worst,
    command: perturbation ? perturbed_command(record, perturbation) : exact_command(record),
  };
}

function row_of(record, groups) {
  const lacking = lacking_of(record);
  const checks = new Map(record.checks.map((check) => [check.quantity, check]));
  return {
    case: record.case,
    title: record.title,
    verdict: record.verdict,
    ended: record.checks.length > 0 ? "" : record.error || record.notes.join("; "),
    cells: groups.map((group) => {
      if (checks.has(group)) return cell_of(record, checks.get(group));
      return lacking.has(group) ? { lacking: lacking.get(group) } : null;
    }),
  };
}

// Why a rung does not hold, in words.
function failure_of(record) {
  if (record.verdict === "error") return `broke off: ${record.error}`;
  const check = deciding_check(record);
  if (!check) return "";
  const words = `${check.quantity}: ${margin_text(margin(check))}`;
  return check.worst ? `${words}; ${check.worst}` : words;
}

const rung_told = (rung) =>
  rung && {
    text: rung.text,
    case: rung.record.case,
    verdict: rung.record.verdict,
    command: exact_command(rung.record),
    ...(rung.holds === false && {
      failure: failure_of(rung.record),
      recorded: Boolean(rung.record.frames),
    }),
  };

function ladder_row(name, entries) {
  const rungs = [...group_by(entries, ({ text }) => text).values()].map((same) => {
    const record = same.map((one) => one.record).reduce(worse_of);
    return { ...same[0], record, holds: holds(record) };
  });
  const span = span_of(rungs);
  const ends = ["lowest", "highest", "below", "above"].map((end) => [end, rung_told(span[end])]);
  return {
    ...name,
    ...Object.fromEntries(ends),
    beyond: span.beyond,
    decided: span.decided,
    lacking: rungs.filter(({ record }) => record.verdict === "not-applicable").length,
  };
}

const breaks = ({ rows }) => rows.some(({ below, above }) => below || above);

// "a box rests under one so many times as heavy: top = 10" without the rung.
function title_of({ record, parameter }) {
  const end = record.title.lastIndexOf(`: ${parameter} = `);
  return end > 0 ? record.title.slice(0, end) : record.title;
}

function ladder_of(entries, names) {
  const [{ ladder, parameter }] = entries;
  const by_name = group_by(entries, ({ name }) => name);
  return {
    key: `${ladder}/${parameter}`,
    ladder,
    parameter,
    family: family_name(entries[0].record.case),
    title: title_of(entries[0]),
    rows: names
      .filter(({ name }) => by_name.has(name))
      .map((name) => ladder_row(name, by_name.get(name.name))),
  };
}

/** {cases, kept, ladders, whole}: how many there are, each configuration's counted, and of how many nothing is lost. */
export function stability_counts({ tables, names, ladders }) {
  const rows = tables.flatMap((table) => table.rows);
  const climbed = ladders.flatMap((ladder) => ladder.rows).filter(({ decided }) => decided > 0);
  return {
    configurations: Math.max(tables.length, names.length),
    cases: rows.filter(({ verdict }) => verdict !== "not-applicable").length,
    kept: rows.filter(({ verdict }) => verdict === "pass").length,
    ladders: climbed.length,
    whole: climbed.filter(({ below, above }) => !below && !above).length,
  };
}

/**
 * {groups, tables, names, ladders}, null where no record is of either kind. `entries`: [{record, run}] that are
 * shown, `heads` of the runs; `name_of(record)` is what its column is called, `series_of` names its run too.
 */
export function stability_of(entries, name_of, series_of) {
  const own = entries
    .filter(({ record }) => is_perturbed(record.case) || is_ladder(record.case))
    .map((entry) => ({ ...entry, name: series_of(entry), rung: rung_of(entry.record.case) }));
  if (own.length === 0) return null;
  const configurations = new Map(own.map(({ record, name }) => [name, name_of(record)]));
  const place = ordered_configurations(configurations.values());
  const names = [...configurations]
    .map(([name, configuration]) => ({ name, configuration }))
    .sort((a, b) => place.indexOf(a.configuration) - place.indexOf(b.configuration));

  const perturbed = natural_sort(
    own.filter(({ record }) => is_perturbed(record.case)),
    ({ record }) => record.case,
  );
  const groups = groups_of(perturbed.map(({ record }) => record));
  const claims = new Map(
    perturbed.flatMap(({ record }) =>
      record.checks.map(({ quantity, claim }) => [quantity, claim]),
    ),
  );
  const tables = group_by(perturbed, ({ name }) => name);
  const rungs = own
    .filter(({ rung }) => rung)
    .map(({ record, name, rung }) => ({ ...rung, record, name }));
  const ladders = [...group_by(rungs, (one) => `${one.ladder}/${one.parameter}`).values()].map(
    (group) => ladder_of(group, names),
  );
  return {
    groups: groups.map((name) => ({ name, claim: claims.get(name) ?? "" })),
    tables: names
      .filter(({ name }) => tables.has(name))
      .map((name) => ({
        ...name,
        rows: tables.get(name.name).map(({ record }) => row_of(record, groups)),
      })),
    names: names.filter(({ name }) => rungs.some((rung) => rung.name === name)),
    // What breaks comes first.
    ladders: [...ladders.filter(breaks), ...ladders.filter((one) => !breaks(one))],
  };
}
