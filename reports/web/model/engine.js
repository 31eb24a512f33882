// SPDX-License-Identifier: GPL-3.0-or-later
// A run of `./stiction compare engines`: what its records are, and what its rows are called. An answer is
// a record of a neutral case; what the answers of an engine to a question come to is a record engines/….
import { rules_on_contacts } from "./rule.js";
import { attributes_of, variant_labels } from "./variant.js";

const FOLDER = "engines/";
export const ENGINE_FINDINGS = `${FOLDER}findings`;

/** The engine that this project comes with. */
export const OURS = "stiction";

/** The engine of which that of a record is another build, as in single precision; "" mostly. */
export const build_of = ({ settings }) => settings.build_of ?? "";

/** Whether a record is neither of ours nor of another build of it. */
export const is_of_others = (record) => record.engine !== OURS && build_of(record) !== OURS;

export const is_engine_case = (name) => name.startsWith(FOLDER) && name !== ENGINE_FINDINGS;

/** The question that a case engines/… is about. */
export const question_of = (case_name) => case_name.slice(FOLDER.length);

export const case_of_question = (id) => FOLDER + id;

/** Whether a record is an engine's answer to a question, with one effort. */
export const is_answer = ({ case: name, settings }) =>
  !is_engine_case(name) && settings.configuration !== undefined && settings.effort !== undefined;

/** Whether a record is of such a run. */
export const is_of_engines = (record) => is_engine_case(record.case) || is_answer(record);

/** "bullet · best", as row_name() in validation/comparison/engines/trials.h. */
export const engine_name = ({ engine, settings }) =>
  [engine, settings.configuration].filter(Boolean).join(" · ");

// The number of its like before it, from the second on: two runs may hold the same.
function told_apart(names) {
  const counts = new Map();
  return names.map((name) => {
    counts.set(name, (counts.get(name) ?? 0) + 1);
    return counts.get(name) > 1 ? `${name} #${counts.get(name)}` : name;
  });
}

// The rung of the ladder is told where there are several.
function engine_labels(records, run_of) {
  const efforts = new Set(records.map(({ settings }) => settings.effort));
  const name = (record, i) =>
    [
      engine_name(record),
      efforts.size > 1 && is_answer(record) && `effort ${record.settings.effort}`,
      run_of(i),
    ]
      .filter(Boolean)
      .join(" · ");
  return records.map(name);
}

/**
 * One label for each of some records: engines' by engine, configuration and effort, others by what tells
 * them apart. `run_of(index)` names a record's run; `group_of` as for variant_labels().
 */
export function record_labels(records, run_of, group_of) {
  if (records.length === 0 || !records.every(is_of_engines))
    return variant_labels(
      records.map((record, i) => attributes_of(record, run_of(i))),
      group_of,
    );
  const several = new Set(records.map((_, i) => run_of(i))).size > 1;
  return engine_labels(records, several ? run_of : () => "");
}

/** The labels of those of a case's records that are engines', "" for the others. */
export function own_labels(records) {
  const own = records.filter(is_of_engines);
  const labels = engine_labels(own, () => "");
  const of = new Map(own.map((record, i) => [record, labels[i]]));
  return records.map((record) => of.get(record) ?? "");
}

/** The variants of a comparison: engines, in the form that rules_on_contacts() gives rules. */
export function compared_variants(records, run_of = () => "") {
  if (records.length === 0 || !records.every(({ case: name }) => is_engine_case(name)))
    return rules_on_contacts(records, run_of);
  const named = told_apart(
    records.map((record, i) =>
      [record.case, [engine_name(record), run_of(i)].filter(Boolean).join(" · ")].join("\n"),
    ),
  ).map((text) => text.slice(text.indexOf("\n") + 1));
  return named.map((name, i) => ({
    rule: records[i].engine,
    words: name,
    name,
    contacts: "",
    label: name,
  }));
}

const AGAIN = "again: ";

/** The command that gives an engine's usual answer again; "" where none is told. */
export const command_of = ({ notes }) => notes.find(is_command)?.slice(AGAIN.length) ?? "";

export const is_command = (note) => note.startsWith(AGAIN);

/** The neutral case that a command asks. */
export const case_of_command = (command) => /--case '([^']+)'/.exec(command)?.[1] ?? "";
