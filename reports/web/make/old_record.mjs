// SPDX-License-Identifier: GPL-3.0-or-later
// Records of schema versions 1 to 3 in the words of the newest, as reports/record/old_record.h.
import { to_number } from "../model/number.js";

const NEWEST = 4;
const WORDS = { limit: "expected-shortfall", shown: "for-information" };
const FAILED = "failed: ";
const PARAMETER_VALUES = /^([^ \t\n\v\f\r]+) = (.*)$/s;
const REAL = /^-?(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?$/i;

const word_of = (verdict) => WORDS[verdict] ?? verdict;

function share_of_tolerance(error, tolerance) {
  const size = Math.abs(to_number(error));
  const most = to_number(tolerance);
  if (Number.isNaN(size) || Number.isNaN(most)) return "inf";
  if (size === 0) return 0;
  return most > 0 && size < Infinity ? size / most : "inf";
}

// 1 stood for no scale, but where the expected value is 1 too it is that.
function upgraded_check(check) {
  const { scale, digits, limit, expected_low, expected_high, ...kept } = check;
  const has_scale = scale !== 1;
  return {
    ...kept,
    ...(has_scale && Math.abs(scale) !== Math.abs(check.expected) && { scale }),
    ...((has_scale || check.expected !== 0) && { digits }),
    of_tolerance: share_of_tolerance(check.error, check.tolerance),
    ...(expected_low !== undefined && { band: [expected_low, expected_high] }),
    ...(limit !== undefined && { cause: limit }),
    verdict: word_of(check.verdict),
  };
}

const is_figure = (check) =>
  check?.verdict === "shown" && check.tolerance === 0 && /^none\b/.test(check.reason);

// A decimal number that neither overflows nor underflows.
function is_real(text) {
  const value = Number(text);
  const underflows = value === 0 && /^[^e]*[1-9]/i.test(text);
  return REAL.test(text) && Number.isFinite(value) && !underflows;
}

function failure_of(note) {
  const text = note.slice(FAILED.length);
  const [, parameter, list] = PARAMETER_VALUES.exec(text) ?? [];
  const values = list?.split(", ");
  return values?.every(is_real)
    ? { reason: "it broke", parameter, values: values.map(Number) }
    : { reason: text, parameter: "", values: [] };
}

/** The record itself when it is of the newest version. What is no record stays as wrong as it is. */
export function upgraded(record) {
  const { schema_version: version, checks, notes } = record;
  if (!(Number.isInteger(version) && version >= 1 && version < NEWEST)) return record;
  if (!Array.isArray(checks) || !checks.every((check) => check instanceof Object)) {
    return { ...record, schema_version: NEWEST };
  }
  const is_list = Array.isArray(notes) && notes.every((note) => typeof note === "string");
  const is_failure = (note) => note.startsWith(FAILED);
  return {
    ...record,
    schema_version: NEWEST,
    verdict: word_of(record.verdict),
    checks: checks.filter((check) => !is_figure(check)).map(upgraded_check),
    figures: checks
      .filter(is_figure)
      .map(({ quantity, unit, claim, value }) => ({ quantity, unit, meaning: claim, value })),
    ...(is_list && {
      notes: notes.filter((note) => !is_failure(note)),
      failures: notes.filter(is_failure).map(failure_of),
    }),
  };
}
