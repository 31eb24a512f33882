// SPDX-License-Identifier: GPL-3.0-or-later
import { parseArgs } from "node:util";

export const USAGE = `NAME
       stiction-report - one self-contained HTML page of one or several runs

SYNOPSIS
       ./stiction report DIR... [--against DIR]... [--out FILE] [OPTIONS]
       ./stiction report DIR... --manual [FILE] [--title TEXT]

DESCRIPTION
       Makes a page of what runs of validate, compare, bench or track have
       recorded: verdicts, plots and recordings, in one file that opens offline and
       can be mailed. With --against it says what changed since an earlier run:
       in the page, which is then another file, and in short on the screen.

ARGUMENTS
       DIR
              A run's folder, or an out-dir whose 'latest' points to one, else its
              newest; several are merged, and parts of a run (--shard) are shown
              as that run

WHAT IS SHOWN
       --against DIR
              An earlier run to compare with; repeatable
       --title TEXT
              The page's title

WHAT IS WRITTEN
       --out FILE
              The page; without it report.html in the first run's folder, with
              --against report-against-NAME.html, NAME being that of the earlier run
       --svg DIR
              Each plot as an SVG file too
       --manual [FILE]
              The verification manual instead of the page, a page a case: one HTML
              file that needs no JavaScript, or a PDF where FILE ends so (that needs
              Chromium); without FILE verification-manual.html in the first run's
              folder
       --limit MB
              How large the page may get; time series and recordings are left out
              beyond it, largest first [15]

OPTIONS
       -h, --help
              Print this help message and exit

EXIT STATUS
       0
              written; with --against nothing got worse
       1
              something did: a verdict is worse, or a check has fewer digits
       2
              could not: bad input, a full disk, no case that both runs have

FILES
       RUN/report.html
              the page
       RUN/records.jsonl, RUN/frames/
              what it is made of (reports/record/schema.md)

EXAMPLES
       ./stiction report validation-report
              the page of the last run
       ./stiction report NEW --against OLD
              what changed in verdicts, digits and cost
       ./stiction report validation-report --svg plots
              each plot as an SVG file too
       ./stiction report validation-report --manual manual.pdf
              the verification manual, for print

SEE ALSO
       ./stiction help validate, reports/web/README.md
`;

// FILE may be left out: it is what follows and ends as such a file does.
const is_manual_file = (word) => /\.(html?|pdf)$/i.test(word ?? "");

const with_manual_file = (words) =>
  words.map((word, i) =>
    word === "--manual" && !is_manual_file(words[i + 1]) ? "--manual=" : word,
  );

/** The command line as data. Throws an Error with one sentence for what it cannot be. */
export function parse_arguments(words) {
  const { values, positionals } = parseArgs({
    args: with_manual_file(words),
    allowPositionals: true,
    options: {
      out: { type: "string" },
      title: { type: "string" },
      against: { type: "string", multiple: true, default: [] },
      svg: { type: "string" },
      manual: { type: "string" },
      limit: { type: "string", default: "15" },
      help: { type: "boolean", short: "h", default: false },
    },
  });
  const limit = Number(values.limit);
  if (!(limit > 0)) throw new Error(`--limit needs a number of megabytes, not '${values.limit}'`);
  if (values.manual !== undefined && (values.out || values.svg))
    throw new Error("--manual writes the manual alone: it goes neither with --out nor with --svg");
  if (values.manual && !is_manual_file(values.manual))
    throw new Error(`--manual writes a .html or .pdf file, not '${values.manual}'`);
  if (!values.help && positionals.length === 0)
    throw new Error("name the folder of a run; --help explains");
  return { ...values, limit_bytes: limit * 1e6, folders: positionals };
}
