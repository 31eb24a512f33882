// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that run a case again.
import { OURS } from "./engine.js";
import { PERTURBED, perturbed_of } from "./perturbation.js";

/** A word of a shell's command line. */
const quoted = (word) => `'${word.replace(/'/g, `'\\''`)}'`;

// A case's name is a pattern: what has a meaning in one stands for any sign.
const pattern = (name) => name.replace(/[[\]*?\\]/g, "?");

// As rerun_command() in reports/text/configuration_text.h; `more`: what stands behind the case.
function command_of({ case: name, engine, point }, more = []) {
  if (point) return `./stiction sweep STUDY.toml --point ${quoted(point)}`;
  if (name.startsWith("sweep/")) return "./stiction sweep STUDY.toml"; // which, no record tells
  const file = name.startsWith("user/") && "PROBLEM.toml"; // which, no record tells
  const words = ["./stiction validate", file, `--case ${quoted(pattern(name))}`];
  return [...words, engine !== OURS && `--engine ${quoted(engine)}`, ...more]
    .filter(Boolean)
    .join(" ");
}

/** The case with all its configurations, on the engine of a record. */
export const case_command = (record) => command_of(record);

// What chooses the record's configuration alone; none where nobody named it.
const configuration_words = ({ configuration, differs = {} }) =>
  configuration
    ? [
        `--configuration ${quoted(configuration)}`,
        ...Object.entries(differs).map(([name, value]) =>
          name === PERTURBED ? `--perturb ${quoted(value)}` : `--set ${quoted(`${name}=${value}`)}`,
        ),
      ]
    : [];

/** The same in the record's configuration alone; "" where nobody named it. */
export const record_command = (record) =>
  record.configuration && !record.case.startsWith("sweep/")
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
