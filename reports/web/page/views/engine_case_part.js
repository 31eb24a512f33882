// SPDX-License-Identifier: GPL-3.0-or-later
// A question to engines: their answers side by side, work and precision, what broke, and the commands.
import { case_of_command, command_of, is_command } from "../../model/engine.js";
import { answer_of, failed_efforts } from "../../model/engine_answer.js";
import { group_by } from "../../model/family.js";
import { counted, VERDICTS } from "../../model/verdict.js";
import { command } from "../widgets/command.js";
import { h } from "../dom.js";
import { figures_table } from "./figures_table.js";
import { case_hash } from "../route.js";

/** How many answered: in a comparison no verdict says so. */
export function answers_mark(records) {
  const counts = {};
  for (const record of records) {
    const { kind } = answer_of(record);
    counts[kind] = (counts[kind] ?? 0) + 1;
  }
  const words = [
    `${counts.told ?? 0} of ${records.length} answer`,
    counts.never && `${counts.never} never get there`,
    counts.broke && `✕ ${counts.broke} broke`,
    counts.lacks && `${counts.lacks} cannot be asked`,
  ];
  return h(
    "span",
    { class: "verdict verdict-for-information answers-mark" },
    words.filter(Boolean).join(", "),
  );
}

/** How answers do against the tolerances of their case: no verdict of all. */
export const judged_mark = (records) => {
  const counts = group_by(records, ({ verdict }) => verdict);
  const words = VERDICTS.filter((verdict) => counts.has(verdict)).map((verdict) =>
    counted(verdict, counts.get(verdict).length),
  );
  return h("span", { class: "verdict verdict-for-information answers-mark" }, words.join(", "));
};

const list_part = (title, items) =>
  items.length > 0 && h("div", { class: "notes" }, h("h2", {}, title), h("ul", {}, items));

const line = (label, text) => h("li", {}, h("strong", {}, `${label}: `), text);

// Of one reason all its efforts in one line.
function broken_lines({ record, label }) {
  const { kind, why } = answer_of(record);
  const by_reason = new Map(kind === "broke" ? [[why, []]] : []);
  for (const { effort, reason } of failed_efforts(record))
    by_reason.set(reason, [...(by_reason.get(reason) ?? []), effort]);
  return [...by_reason].map(([reason, efforts]) =>
    line(label, efforts.length > 0 ? `${reason} (effort ${efforts.join(", ")})` : reason),
  );
}

function lacking_lines({ record, label }) {
  const { kind, why } = answer_of(record);
  return kind === "lacks" ? [line(label, why)] : [];
}

const note_lines = ({ record, label }) =>
  answer_of(record).kind === "lacks"
    ? []
    : record.notes.filter((note) => !is_command(note)).map((note) => line(label, note));

function commands_part(entries, chosen) {
  const told = entries.filter(({ record }) => command_of(record) !== "");
  return (
    told.length > 0 && [
      h("h2", {}, "Ask it again"),
      h(
        "dl",
        { class: "commands" },
        told.map(({ record, label }) =>
          h(
            "div",
            { class: label === chosen ? "chosen" : "" },
            h("dt", {}, label),
            h("dd", {}, command(command_of(record), label)),
          ),
        ),
      ),
    ]
  );
}

// The records that this page is made of.
function source_line(entries, cases) {
  const names = new Set(entries.map(({ record }) => case_of_command(command_of(record))));
  const links = [...names]
    .filter((name) => cases.has(name))
    .map((name) => [" ", h("a", { href: case_hash(name) }, name)]);
  return (
    links.length > 0 && h("p", {}, "Every answer, with each effort and what was checked:", links)
  );
}

/** `cases`: the names that the page holds; `chosen`: the engine · configuration that was asked for. */
export const engine_case_part = (entries, figures, cases, chosen) => [
  h("h2", {}, "Side by side"),
  h(
    "div",
    { class: "engine-answers" },
    figures_table(entries, { heading: "Engine · configuration", chosen }),
  ),
  figures.length > 0
    ? h("div", { class: "plot-pairs" }, figures)
    : h("p", {}, "Each engine was asked with its usual effort alone: there is no curve."),
  list_part("What broke", entries.flatMap(broken_lines)),
  list_part("What an engine lacks", entries.flatMap(lacking_lines)),
  list_part("Notes", entries.flatMap(note_lines)),
  commands_part(entries, chosen),
  source_line(entries, cases),
];
