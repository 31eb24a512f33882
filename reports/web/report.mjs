// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction report`: records → one self-contained page, or the verification manual.
import { readFileSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { write_whole } from "./make/files.mjs";
import { parse_arguments, USAGE } from "./make/arguments.mjs";
import { html_page, read_bundles } from "./make/page.mjs";
import { manual_html } from "./make/manual.mjs";
import { page_data } from "./make/page_data.mjs";
import { is_empty_part, join_parts, parts_in } from "./make/parts.mjs";
import { drawing_html, read_problems } from "./make/drawing.mjs";
import { pdf_of } from "./make/pdf.mjs";
import { read_recordings } from "./make/recordings.mjs";
import { read_run } from "./make/read_run.mjs";
import { is_engine_case } from "./model/engine.js";
import { told_changes } from "./make/told_changes.mjs";
import { run_heads } from "./make/run_heads.mjs";
import { show, tell } from "./make/tell.mjs";
import { write_svg_files } from "./make/svg_files.mjs";

// Broken runs are told of; the others are shown.
function read_all(folders, warnings) {
  const runs = [];
  const failures = [];
  for (const folder of folders.flatMap(parts_in)) {
    if (is_empty_part(folder)) continue;
    try {
      const run = read_run(folder);
      warnings.push(...run.warnings);
      runs.push(run);
    } catch (error) {
      failures.push(error.message);
    }
  }
  if (runs.length === 0 && failures.length > 0) throw new Error(failures.join("; "));
  warnings.push(...failures.map((failure) => `${failure}. It is left out.`));
  return runs;
}

// A run's own page stays beside that of a comparison.
const page_name = (against) =>
  against.length === 0
    ? "report.html"
    : `report-against-${against
        .map(({ name }) => name.replace(/[^\w.-]/g, "_"))
        .join("-")
        .slice(0, 200)}.html`;

const is_of_engines = ({ records }) => records.some((record) => is_engine_case(record.case));

const default_title = (runs) =>
  `${runs.every(is_of_engines) ? "Engines side by side" : "Validation report"}, ${runs
    .map(({ name }) => name)
    .slice(0, 3)
    .join(", ")}`;

const manual_style = () =>
  readFileSync(join(dirname(fileURLToPath(import.meta.url)), "bundle", "manual.css"), "utf8");

// What validate --check-only leaves is drawn; false where the folder holds no such thing.
function drawings({ folders: [folder] }) {
  const problems = read_problems(folder);
  if (problems === null) return false;
  const file = join(folder, "problems.html");
  write_whole(file, drawing_html(problems, manual_style()));
  show(`Drawing: ${file}`);
  return true;
}

async function manual(options) {
  const warnings = [];
  const parts = read_all(options.folders, warnings);
  const { recordings, warnings: recording_warnings } = read_recordings(parts);
  const runs = join_parts(parts, warnings);
  const html = await manual_html({
    runs,
    heads: run_heads(runs, []),
    title: options.title ?? "Verification manual",
    style: manual_style(),
    bytes_of: (name) => recordings.find((recording) => recording.name === name)?.bytes ?? null,
  });
  const file = options.manual || join(runs[0].folder, "verification-manual.html");
  write_whole(file, /\.pdf$/i.test(file) ? await pdf_of(html) : html);
  for (const warning of new Set([...warnings, ...recording_warnings])) tell(warning);
  show(`Manual: ${file} (${(statSync(file).size / 1e6).toFixed(1)} MB)`);
}

async function report(options) {
  const warnings = [];
  const parts = read_all(options.folders, warnings);
  const parts_against = read_all(options.against, warnings);
  const { recordings, warnings: recording_warnings } = read_recordings([
    ...parts,
    ...parts_against,
  ]);
  warnings.push(...recording_warnings);
  const runs = join_parts(parts, warnings);
  const against = join_parts(parts_against, warnings);

  const data = page_data({
    runs,
    against,
    warnings: [...new Set(warnings)],
    title: options.title ?? default_title(runs),
  });
  const told = data.comparison
    ? told_changes(data.comparison, against.map(({ name }) => name).join(", "))
    : null;
  const bundles = read_bundles(join(dirname(fileURLToPath(import.meta.url)), "bundle"));
  const page = html_page({ data, bundles, recordings, limit_bytes: options.limit_bytes });
  const bytes = Buffer.byteLength(page.html);
  const size = `${(bytes / 1e6).toFixed(1)} MB`;
  if (bytes > options.limit_bytes)
    page.warnings.push(`The page has ${size} all the same: that many records are listed in it.`);
  const file = options.out ?? join(runs[0].folder, page_name(against));
  write_whole(file, page.html);
  for (const warning of page.warnings) tell(warning);
  if (options.svg) {
    const count = await write_svg_files(options.svg, data);
    show(`Plots: ${count} SVG files in ${options.svg}`);
  }
  if (told) {
    show(told.text);
    process.exitCode = told.code;
  }
  show(`Page: ${file} (${size})`);
}

// What is being written is written whole first: these come between two pieces of work.
for (const [signal, number] of [
  ["SIGINT", 2],
  ["SIGTERM", 15],
])
  process.once(signal, () => process.exit(128 + number));

try {
  const options = parse_arguments(process.argv.slice(2));
  if (options.help) show(USAGE);
  else if (options.manual !== undefined) await manual(options);
  else if (!drawings(options)) await report(options);
} catch (error) {
  tell(error.message);
  process.exitCode = 2;
}
