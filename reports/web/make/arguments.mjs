// SPDX-License-Identifier: GPL-3.0-or-later
import { parseArgs } from "node:util";

export const USAGE = `stiction report: records → one self-contained HTML page

  report DIR… [--out FILE] [--title TEXT] [--against DIR]… [--svg DIR] [--limit MB]
  report DIR… --manual [FILE] [--title TEXT]

  DIR            a run's folder, or an out-dir whose 'latest' points to one; several are merged
  --out FILE     the page; without it report.html in the first run's folder
  --title TEXT   the page's title
  --against DIR  an earlier run to compare with; repeatable
  --svg DIR      writes each plot as an SVG file too
  --manual [FILE]
                 writes the verification manual instead of the page: one static HTML file, or a PDF
                 when FILE ends so (that needs Chromium), with a page a case; without FILE
                 verification-manual.html in the first run's folder
  --limit MB     how large the page may get; time series and recordings are left out beyond it,
                 largest first (15)

Exit code: 0 written, 2 could not (bad input, a full disk).
`;

// FILE may be left out: it is what follows and ends as such a file does.
const is_manual_file = (word) => /\.(html?|pdf)$/i.test(word ?? "");

const with_manual_file = (words) =>
  words.map((word, i) => (word === "--manual" && !is_manual_file(words[i + 1]) ? "--manual=" : word));

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
  if (values.manual && !is_manual_file(values.manual))
    throw new Error(`--manual writes a .html or .pdf file, not '${values.manual}'`);
  if (!values.help && positionals.length === 0)
    throw new Error("name the folder of a run; --help explains");
  return { ...values, limit_bytes: limit * 1e6, folders: positionals };
}
