// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that run a case again.
import { OURS } from "./engine.js";
import { PERTURBED, perturbed_of } from "./perturbation.js";

/** A word of a shell's command line. */
const quoted = (word) => `'${word.replace(/'/g, `'\\''`)}'`;

// A case's name is a pattern: what has a meaning in one stands for any sign.
const pattern = (name) => name.replace(/[[\]*?\\]/g, "?");

// What other programs than validate run again, by the first part of a case's name; with all configurations.
const OTHERS = new Map([
  ["sweep", () => "./stiction sweep STUDY.toml"], // which, no record tells
  [
    "bench",
    (rest) => {
      if (rest === "features") return "./stiction bench";
      const [family, size = ""] = rest.replace("contacts=", "contacts:").split("/");
      const which = size.startsWith("contacts:") ? `${size}$` : "";
      return `./stiction bench --benchmark_filter=${quoted(`/${family}/${which}`)}`;
    },
  ],
  [
    "sizes",
    (family, { settings: { before = "REF" } }) =>
      `./stiction track sizes --against ${quoted(before)} --benchmark ${quoted(`step/${family}/*`)}`,
  ],
  ["trend", (subject) => `./stiction track history --metric ${quoted(`${pattern(subject)}#*`)}`],
]);

// The command of another program; "" where it is one of validate's cases.
function other_command(record) {
  const [, first, rest] = record.case.match(/^([^/]*)\/(.*)$/) ?? [];
  return OTHERS.get(first)?.(rest, record) ?? "";
}

// As rerun_command() in reports/text/configuration_text.h; `more`: what stands behind the case.
function command_of(record, more = []) {
  const { case: name, engine, point } = record;
  if (point) return `./stiction sweep STUDY.toml --point ${quoted(point)}`;
  const other = other_command(record);
  if (other) return other;
  const file = name.startsWith("user/") && "PROBLEM.toml"; // which, no record tells
  const words = ["./stiction validate", file, `--case ${quoted(pattern(name))}`];
  return [...words, engine !== OURS && `--engine ${quoted(engine)}`, ...more]
    .filter(Boolean)
    .join(" ");
}

/** The case with all its configurations, on the engine of a record. */
export const case_command = (record) => command_of(record);

// What differs and is no setting of the engine: the second as kFinerSetting in reports/record/record.h.
const OPTIONS = new Map([
  [PERTURBED, "--perturb"],
  ["finer", "--finer"],
]);

// What chooses the record's configuration alone; none where nobody named it.
const configuration_words = ({ configuration, differs = {} }) =>
  configuration
    ? [
        `--configuration ${quoted(configuration)}`,
        ...Object.entries(differs).map(([name, value]) =>
          OPTIONS.has(name)
            ? `${OPTIONS.get(name)} ${quoted(value)}`
            : `--set ${quoted(`${name}=${value}`)}`,
        ),
      ]
    : [];

/** The same in the record's configuration alone; "" where nobody named it. */
export const record_command = (record) =>
  record.configuration && !other_command(record)
    ? command_of(record, configuration_words(record))
    : "";

/** Exactly the record: its case, in its configuration where that has a name. */
export const exact_command = (record) => command_of(record, configuration_words(record));

/** One perturbation (model/perturbation.js) of the case that a record perturbed/… is about. */
export const perturbed_command = (record, perturbation) =>
  command_of({ ...record, case: perturbed_of(record.case) }, [
    `--perturb ${quoted(perturbation)}`,
    ...configuration_words(record),
  ]);
