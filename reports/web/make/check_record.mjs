// SPDX-License-Identifier: GPL-3.0-or-later
// A check of a parsed line against reports/record/schema.json.
import Ajv from "ajv";
import schema from "../../record/schema.json";
import { upgraded } from "./old_record.mjs";

const NEWEST_SCHEMA = schema.properties.schema_version.const;

const is_record = new Ajv({ strict: false }).compile(schema);

const is_object = (value) => typeof value === "object" && value !== null && !Array.isArray(value);

// "/checks/0/value" → "checks[0].value"
const path_of = (pointer) =>
  pointer
    .slice(1)
    .replaceAll(/\/(\d+)(?=\/|$)/g, "[$1]")
    .replaceAll("/", ".")
    .replaceAll("~1", "/")
    .replaceAll("~0", "~");

const EXPECTED = {
  string: "expected a string",
  boolean: "expected true or false",
  array: "expected a list",
  object: "expected an object",
  integer: "expected a whole number from 0",
};

const value_at = (value, pointer) =>
  pointer
    .split("/")
    .slice(1)
    .reduce((inner, key) => inner?.[key.replaceAll("~1", "/").replaceAll("~0", "~")], value);

// One sentence of ajv's complaints: a number that is none fails two branches and their sum.
function sentence(value, errors) {
  const error = errors.find(({ keyword }) => keyword === "anyOf") ?? errors[0];
  const { instancePath: pointer, keyword, params } = error;
  const at = (name, what) => (name === "" ? what : `${name}: ${what}`);
  if (keyword === "required") {
    return at(path_of(`${pointer}/${params.missingProperty}`), "the required field is missing");
  }
  const path = path_of(pointer);
  if (keyword === "anyOf") return at(path, 'expected a number, "nan", "inf" or "-inf"');
  if (keyword === "type") return at(path, EXPECTED[params.type]);
  if (keyword === "minItems" || keyword === "maxItems") {
    return at(path, `expected ${params.limit} numbers`);
  }
  if (keyword === "minimum") return at(path, EXPECTED.integer);
  if (keyword === "enum") {
    return at(path, `unknown word ${JSON.stringify(value_at(value, pointer))?.slice(0, 40)}`);
  }
  return at(path, error.message);
}

const EMPTY = {
  title: "",
  settings: {},
  variant: "",
  configuration: "",
  differs: {},
  simulations: 0,
  error: "",
  figures: [],
  failures: [],
  notes: [],
  state_hash: "",
  meshes: [],
  series: [],
  frames: "",
};
const EMPTY_CHECK = { formula: "", worst: "", cause: "", because: "", headline: "" };
const EMPTY_FAILURE = { parameter: "", values: [] };

// A copy for each: what is filled in may be changed later.
function fill(value, empty) {
  for (const [name, nothing] of Object.entries(empty)) {
    if (value[name] === undefined) value[name] = structuredClone(nothing);
  }
}

/**
 * {record} of a parsed line, in the newest schema and with what may miss filled in; or {fault}, what is
 * wrong with it in words.
 */
export function checked(line) {
  if (!is_object(line)) return { fault: EXPECTED.object };
  if (line.schema_version > NEWEST_SCHEMA) {
    return {
      fault: `schema version ${line.schema_version} is newer than this program's, ${NEWEST_SCHEMA}`,
    };
  }
  const record = upgraded(line);
  if (!is_record(record)) return { fault: sentence(record, is_record.errors) };
  for (const [i, { x, y }] of (record.series ?? []).entries()) {
    if (x.length !== y.length) return { fault: `series[${i}]: has not as many x as y` };
  }
  fill(record, EMPTY);
  fill(record.cost, { phase_seconds: {} });
  for (const check of record.checks) fill(check, EMPTY_CHECK);
  for (const failure of record.failures) fill(failure, EMPTY_FAILURE);
  return { record };
}
