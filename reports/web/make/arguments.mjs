// SPDX-License-Identifier: GPL-3.0-or-later
import { parseArgs } from "node:util";

export const USAGE = `NAME
       stiction-report - one self-contained HTML page of one or several runs

SYNOPSIS
       ./stiction report DIR... [--against DIR]... [--out FILE] [OPTIONS]

DESCRIPTION
       Makes a page of what runs of validate, compare, bench or track have
       recorded: verdicts, plots and recordings, in one file that opens offline and
       can be mailed. With --against it says what changed since an earlier run.

ARGUMENTS
       DIR
              A run's folder, or an out-dir whose 'latest' points to one; several
              are merged

WHAT IS SHOWN
       --against DIR
              An earlier run to compare with; repeatable
       --title TEXT
              The page's title

WHAT IS WRITTEN
       --out FILE
              The page; without it report.html in the first run's folder
       --svg DIR
              Each plot as an SVG file too
       --limit MB
              How large the page may get; time series and recordings are left out
              beyond it, largest first [15]

OPTIONS
       -h, --help
              Print this help message and exit

EXIT STATUS
       0
              written
       2
              could not: bad input, a full disk

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

SEE ALSO
       ./stiction help validate, reports/web/README.md
`;

/** The command line as data. Throws an Error with one sentence for what it cannot be. */
export function parse_arguments(words) {
  const { values, positionals } = parseArgs({
    args: words,
    allowPositionals: true,
    options: {
      out: { type: "string" },
      title: { type: "string" },
      against: { type: "string", multiple: true, default: [] },
      svg: { type: "string" },
      limit: { type: "string", default: "15" },
      help: { type: "boolean", short: "h", default: false },
    },
  });
  const limit = Number(values.limit);
  if (!(limit > 0)) throw new Error(`--limit needs a number of megabytes, not '${values.limit}'`);
  if (!values.help && positionals.length === 0)
    throw new Error("name the folder of a run; --help explains");
  return { ...values, limit_bytes: limit * 1e6, folders: positionals };
}
