// SPDX-License-Identifier: GPL-3.0-or-later
// The index's rows (make/page_data.mjs writes them) as objects.
import { margin } from "../model/check_text.js";
import { family_name, group_by } from "../model/family.js";
import { letter_of } from "../model/machine.js";
import { to_number } from "../model/number.js";
import { rules_on_contacts } from "../model/rule.js";
import { variant_labels } from "../model/variant.js";

function check_of(values, texts) {
  if (!values) return null;
  const [
    quantity,
    unit,
    value,
    expected,
    error,
    relative,
    tolerance,
    of_tolerance,
    digits,
    verdict,
    band,
  ] = values;
  const check = {
    quantity: texts[quantity],
    unit: texts[unit],
    value,
    expected,
    error,
    relative: relative === 1,
    tolerance,
    of_tolerance,
    digits: digits === null ? null : to_number(digits),
    verdict: texts[verdict],
    band,
  };
  return { ...check, margin: margin(check) };
}

const CONFIGURATION = 17; // its place in a row

// What tells a record from the others of its case and run: [label], "" where it is the only one.
function labels_of(rows, texts, compared) {
  const attributes = (row) => ({
    configuration: texts[row[CONFIGURATION]],
    ...Object.fromEntries(
      texts[row[5]].split(" ").map((word) => {
        const equals = word.indexOf("=");
        return equals < 0 ? ["engine", word] : [word.slice(0, equals), word.slice(equals + 1)];
      }),
    ),
  });
  const labels = new Map();
  for (const group of group_by(rows, (row) => `${row[0]} ${row[2]}`).values()) {
    if (group.length < 2) continue;
    const all = group.map(attributes);
    const told = compared
      ? rules_on_contacts(
          all.map((settings) => ({ case: "", engine: settings.engine, settings })),
        ).map(({ label }) => label)
      : variant_labels(all);
    told.forEach((label, i) => labels.set(group[i], label));
  }
  return (row) => labels.get(row) ?? "";
}

/** One object a record, in natural order of the case names. */
export function rows_of({ rows, texts, runs, compared, summary }) {
  const is_shown = ([run]) => runs[run].role === "shown";
  const several = new Set(rows.filter(is_shown).map((row) => row.at(-1))).size > 1;
  const columns = new Set(summary?.configurations.map(({ name }) => name));
  const column_of = (engine, configuration) => {
    const long = `${engine} · ${configuration}`;
    return columns.has(long) ? long : configuration;
  };
  const families = new Map();
  const family_of = (name) => {
    if (!families.has(name)) families.set(name, family_name(texts[name]));
    return families.get(name);
  };
  const label_of = labels_of(rows, texts, compared);
  return rows.map((row, index) => {
    const [
      run,
      part,
      name,
      title,
      engine,
      variant,
      verdict,
      seconds,
      steps,
      updates,
      ns,
      checks,
      frames,
      error,
      fewest,
      check,
      label,
      configuration,
      quantities,
      fingerprint,
    ] = row;
    return {
      index,
      run,
      part,
      case: texts[name],
      family: family_of(name),
      title: texts[title],
      engine: texts[engine],
      variant: texts[variant],
      label: label === 0 ? label_of(row) : texts[label],
      of_engines: label !== 0,
      verdict: texts[verdict],
      seconds: to_number(seconds),
      steps,
      updates,
      ns: to_number(ns),
      checks,
      frames: texts[frames],
      error: texts[error],
      fewest: fewest === null ? null : to_number(fewest),
      check: check_of(check, texts),
      configuration: texts[configuration],
      column: column_of(texts[engine], texts[configuration]),
      quantities: texts[quantities],
      // Where all that is shown ran on one, there is nothing to tell apart.
      machine: several ? letter_of(texts[fingerprint]) : "",
    };
  });
}
