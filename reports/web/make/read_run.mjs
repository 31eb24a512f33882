// SPDX-License-Identifier: GPL-3.0-or-later
import { existsSync, readdirSync, realpathSync, statSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { clean } from "./clean_text.mjs";
import { checked } from "./check_record.mjs";
import { read_lines } from "./read_lines.mjs";
import { is_run_name, newest_first } from "./run_order.mjs";

const MOST_WARNINGS = 8;

// The newest of an out-dir's runs that has a record, undefined if none: what was interrupted has no `latest`.
function newest_records_file(path) {
  return readdirSync(path)
    .filter(is_run_name)
    .sort(newest_first)
    .map((name) => join(path, name, "records.jsonl"))
    .find((file) => existsSync(file) && statSync(file).size > 0);
}

// A run's folder, an out-dir with `latest` or else its newest run, or the file itself.
function records_file_of(path) {
  if (!existsSync(path)) throw new Error(`${path} does not exist`);
  if (statSync(path).isFile()) return path;
  for (const file of [join(path, "records.jsonl"), join(path, "latest", "records.jsonl")]) {
    if (existsSync(file)) return file;
  }
  const newest = newest_records_file(path);
  if (newest) return newest;
  throw new Error(
    `${path} holds no records.jsonl, nor does ${join(path, "latest")} or a run in it`,
  );
}

/**
 * The records of a run: {name, folder, records, warnings}. A broken line is left out with a warning,
 * so is a last line that a crash cut off. Throws when there is no record to show.
 */
export function read_run(path) {
  const file = realpathSync(records_file_of(path));
  const folder = dirname(file);
  const records = [];
  const faults = [];
  let cut_off = "";
  let lines = 0;
  read_lines(file, (line, number, complete) => {
    if (line.trim() === "") return;
    ++lines;
    let record;
    let fault;
    try {
      ({ record, fault } = checked(clean(JSON.parse(line), line)));
    } catch {
      fault = "not JSON";
    }
    if (!fault) records.push(record);
    else if (!complete && fault === "not JSON") cut_off = `line ${number}`;
    else faults.push(`line ${number}: ${fault}`);
  });
  const name = basename(folder);
  if (records.length === 0) {
    const first = faults[0] ?? (cut_off && `${cut_off} is cut off`);
    throw new Error(
      lines === 0
        ? `${file} is empty: no case was finished`
        : `${file}: no record can be read (${first})`,
    );
  }
  const warnings = faults
    .slice(0, MOST_WARNINGS)
    .map((fault) => `${name}/records.jsonl, ${fault}. The line is left out.`);
  if (faults.length > MOST_WARNINGS) {
    warnings.push(
      `${name}/records.jsonl: ${faults.length - MOST_WARNINGS} more broken lines are left out.`,
    );
  }
  if (cut_off) {
    warnings.push(
      `${name}/records.jsonl, ${cut_off}: the run was cut off while it wrote. The records before it are shown; cases may be missing.`,
    );
  }
  return { name, folder, records, warnings };
}
