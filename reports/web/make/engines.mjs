// SPDX-License-Identifier: GPL-3.0-or-later
// A run of `./stiction compare engines` in short, for the summary: engine × question, and what it costs.
import { builds_beside } from "../model/build_pairs.js";
import { cheapest_by_machine } from "../model/cheapest_way.js";
import { case_of_command, command_of, compared_variants, question_of } from "../model/engine.js";
import { is_answer, is_engine_case, is_of_engines, OURS } from "../model/engine.js";
import { answer_of } from "../model/engine_answer.js";
import { whole_questions } from "../model/engine_question.js";
import { group_by } from "../model/family.js";
import { figure_of, WORK } from "../model/figure.js";
import { machine_letters } from "../model/machine.js";

/** The records with questions in whole sentences as titles. */
export function with_whole_questions(records) {
  const first = new Map();
  for (const record of records)
    if (is_engine_case(record.case) && !first.has(record.case)) first.set(record.case, record);
  if (first.size === 0) return records;
  const titles = new Map(records.map((record) => [record.case, record.title]));
  const whole = whole_questions(
    [...first.values()].map((record) => ({
      id: question_of(record.case),
      title: record.title,
      case_title: titles.get(case_of_command(command_of(record))) ?? "",
    })),
  );
  const of = new Map([...first.keys()].map((name, i) => [name, whole[i]]));
  return records.map((record) =>
    of.has(record.case) ? { ...record, title: of.get(record.case) } : record,
  );
}

// "m/s", "relative", "" for a bare number.
function error_unit(records) {
  const figures = records.flatMap((record) => record.figures);
  const { unit, meaning } = figures.find(({ quantity }) => quantity === "error") ?? { unit: "" };
  if (unit !== "1") return unit;
  return meaning.includes("relative") ? "relative" : "";
}

const json_number = (value) =>
  Number.isFinite(value) ? value : String(value).toLowerCase().replace("infinity", "inf");

function question(name, told) {
  const records = told.map(({ record }) => record);
  return {
    case: name,
    id: question_of(name),
    words: records[0].title,
    unit: error_unit(records),
    asks: case_of_command(command_of(records[0])),
    has_curve: records.some(({ series }) => series.length > 0),
  };
}

const cell_of = (record) => {
  const { kind, error, why } = answer_of(record);
  return { kind, error: json_number(error), why };
};

// Milliseconds are the page's words: here s, null where nothing was measured.
const seconds_of = (record) => {
  const seconds = record ? figure_of(record, WORK) : NaN;
  return Number.isFinite(seconds) ? seconds : null;
};

// How the answers do against the tolerances of the cases themselves.
function judged(answers) {
  const counts = {};
  for (const { verdict } of answers) counts[verdict] = (counts[verdict] ?? 0) + 1;
  const own = answers.filter(({ engine }) => engine === OURS);
  return {
    counts,
    ours: own.length,
    ours_met: own.filter(({ verdict }) => verdict === "pass").length,
  };
}

/**
 * `entries`: [{record, run}] of the runs that are shown, in the order in which they stand there; `runs`
 * are their heads. Null without records engines/….
 */
export function engines_of(entries, runs) {
  const own = entries.filter(({ record }) => is_engine_case(record.case));
  if (own.length === 0) return null;
  const several = new Set(own.map(({ run }) => run)).size > 1;
  const variants = compared_variants(
    own.map(({ record }) => record),
    (i) => (several ? runs[own[i].run].short : ""),
  );
  const letters = machine_letters(own.map(({ record }) => record));
  const told = own.map(({ record }, i) => ({ record, name: variants[i].name }));
  const by_case = [...group_by(told, ({ record }) => record.case)];
  const questions = by_case.map(([name, group]) => question(name, group));
  const priced = by_case[questions.findIndex(({ has_curve }) => has_curve)] ?? null;
  const rows = [...group_by(told, ({ name }) => name)].map(([name, group]) => {
    const of = new Map(group.map(({ record }) => [record.case, record]));
    return {
      name,
      engine: group[0].record.engine,
      seconds: priced && seconds_of(of.get(priced[0])),
      machine: priced && of.has(priced[0]) ? letters([of.get(priced[0])]) : "",
      cells: questions.map((one) => (of.has(one.case) ? cell_of(of.get(one.case)) : null)),
    };
  });
  return {
    questions,
    priced: priced && question_of(priced[0]),
    rows,
    cheapest: by_case
      .filter((_, i) => questions[i].has_curve)
      .flatMap(([name, group]) =>
        cheapest_by_machine(group).map((ways) => ({ case: name, ...ways })),
      ),
    builds: builds_beside(told),
    judged: judged(entries.map(({ record }) => record).filter(is_answer)),
    others: entries.some(({ record }) => !is_of_engines(record)),
  };
}
