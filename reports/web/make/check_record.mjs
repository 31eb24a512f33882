// SPDX-License-Identifier: GPL-3.0-or-later
// The schema of reports/record/schema.md as data, and a check of a parsed line against it.

const NEWEST_SCHEMA = 3;

const text = (value) => (typeof value === "string" ? null : "expected a string");
const number = (value) =>
  typeof value === "number" || ["nan", "inf", "-inf"].includes(value)
    ? null
    : 'expected a number, "nan", "inf" or "-inf"';
const count = (value) =>
  typeof value === "number" && value >= 0 && Number.isInteger(value)
    ? null
    : "expected a whole number from 0";
const boolean = (value) => (typeof value === "boolean" ? null : "expected true or false");
const word =
  (...words) =>
  (value) =>
    words.includes(value) ? null : `unknown word ${JSON.stringify(value)?.slice(0, 40)}`;

const is_object = (value) => typeof value === "object" && value !== null && !Array.isArray(value);

// A fault with its place before it, once. Without a path only the fact matters: good records, that is
// nearly all, are checked without making a string.
const placed = (fault, path) =>
  path === null || fault.startsWith(path) ? fault : `${path}: ${fault}`;

function list(check) {
  return (value, path) => {
    if (!Array.isArray(value)) return "expected a list";
    for (let i = 0; i < value.length; ++i) {
      const fault = check(value[i], path === null ? null : `${path}[${i}]`);
      if (fault) return placed(fault, path === null ? null : `${path}[${i}]`);
    }
    return null;
  };
}

function map(check) {
  return (value, path) => {
    if (!is_object(value)) return "expected an object";
    for (const [key, entry] of Object.entries(value)) {
      const fault = check(entry, null);
      if (fault) return placed(fault, path === null ? null : `${path}.${key}`);
    }
    return null;
  };
}

// `optional` gives the value that a missing field reads as.
function object(required, optional = {}) {
  const fields = [
    ...Object.entries(required).map(([name, check]) => ({ name, check })),
    ...Object.entries(optional).map(([name, [check, absent]]) => ({ name, check, absent })),
  ];
  return (value, path) => {
    if (!is_object(value)) return "expected an object";
    for (const { name, check, absent } of fields) {
      const here = path === null ? null : path ? `${path}.${name}` : name;
      if (value[name] === undefined) {
        if (absent === undefined) return `${here}: the required field is missing`;
        value[name] = absent();
        continue;
      }
      const fault = check(value[name], here);
      if (fault) return placed(fault, here);
    }
    return null;
  };
}

const verdict = word("pass", "fail", "limit", "refuted", "error", "not-applicable", "shown");
const empty_text = () => "";
const empty_list = () => [];
const empty_map = () => ({});
const no_band = () => undefined;

const check = object(
  {
    quantity: text,
    unit: text,
    claim: text,
    source: text,
    kind: word("analytic", "exact-computed", "self-converged", "external", "golden"),
    value: number,
    expected: number,
    error: number,
    relative: boolean,
    scale: number,
    tolerance: number,
    reason: text,
    digits: number,
    verdict,
  },
  {
    formula: [text, empty_text],
    worst: [text, empty_text],
    limit: [text, empty_text], // version 2's word for cause
    cause: [text, empty_text],
    expected_low: [number, no_band],
    expected_high: [number, no_band],
  },
);

const cost = object({
  cpu_seconds: number,
  steps: count,
  contact_updates: count,
  ns_per_contact_update: number,
  phase_seconds: map(number),
});

const environment = object({ revision: text, toolchain: text, machine: text, date: text });

const series = object({
  name: text,
  unit: text,
  x_name: text,
  x_unit: text,
  x: list(number),
  y: list(number),
});

const mesh = object({
  bodies: text,
  vertices: count,
  tetrahedra: count,
  min_dihedral_angle: number,
  max_dihedral_angle: number,
  min_altitude: number,
});

const record = object(
  {
    schema_version: count,
    case: text,
    engine: text,
    verdict,
    checks: list(check),
    cost,
    environment,
  },
  {
    title: [text, empty_text],
    settings: [map(text), empty_map],
    variant: [text, empty_text],
    error: [text, empty_text],
    notes: [list(text), empty_list],
    state_hash: [text, empty_text],
    meshes: [list(mesh), empty_list],
    series: [list(series), empty_list],
    frames: [text, empty_text],
  },
);

/**
 * What is wrong with a parsed line, in words; null when it is a record. Fields that are not required
 * and missing are filled in.
 */
export function fault_of(value) {
  if (is_object(value) && value.schema_version > NEWEST_SCHEMA) {
    return `schema version ${value.schema_version} is newer than this program's, ${NEWEST_SCHEMA}`;
  }
  if (record(value, null)) return record(value, "");
  for (const [i, one] of value.checks.entries()) {
    if ((one.expected_low === undefined) !== (one.expected_high === undefined))
      return `checks[${i}]: has one end of a band only`;
    if (one.cause === "") one.cause = one.limit;
    delete one.limit;
  }
  for (const [i, one] of value.series.entries()) {
    if (one.x.length !== one.y.length) return `series[${i}]: has not as many x as y`;
  }
  return null;
}
