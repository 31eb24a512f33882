// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that run a case again.
import { OURS } from "./engine.js";

/** A word of a shell's command line. */
const quoted = (word) => `'${word.replace(/'/g, `'\\''`)}'`;

// A case's name is a pattern: what has a meaning in one stands for any sign.
const pattern = (name) => name.replace(/[[\]*?\\]/g, "?");

/** The case with all its configurations, on the engine of a record. */
export const case_command = ({ case: name, engine }) =>
  [
    "./stiction validate",
    engine !== OURS && `--engine ${quoted(engine)}`,
    `--case ${quoted(pattern(name))}`,
  ]
    .filter(Boolean)
    .join(" ");

/** The same in the record's configuration alone; "" where nobody named it. */
export const record_command = (record) =>
  record.configuration
    ? [
        case_command(record),
        `--configuration ${quoted(record.configuration)}`,
        ...Object.entries(record.differs ?? {}).map(
          ([name, value]) => `--set ${quoted(`${name}=${value}`)}`,
        ),
      ].join(" ")
    : "";
