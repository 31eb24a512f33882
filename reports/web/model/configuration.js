// SPDX-License-Identifier: GPL-3.0-or-later
// What people call the way an engine was run. Records that have the field tell it; of older ones it is read
// from their settings.

/** This project's own, in the order in which they are shown. */
export const QUIET = "quiet";
export const FIXED_POINT = "paper, fixed point";
export const SECANT = "paper, secant";
export const NO_MEMORY = "paper, no memory";
export const OLD = "old";
export const OWN_CONFIGURATIONS = [QUIET, FIXED_POINT, SECANT, NO_MEMORY, OLD];

const PAPER_BY_RULE = {
  "fixed-point": FIXED_POINT,
  secant: SECANT,
  none: NO_MEMORY,
};
const QUIET_RULES = ["conjugate-vector", "stored-vector"];

function derived_of({ engine, settings }) {
  const { method, rule, memory, configuration } = settings;
  if (configuration) return configuration;
  if (engine === "stiction" && Object.keys(settings).length === 0) return QUIET;
  if (method === "quiet" || method === "old") return method;
  if (method === undefined && QUIET_RULES.includes(rule)) return QUIET;
  if (method !== undefined && method !== "paper") return engine;
  return (memory === "keep" && "paper, memory kept") || (PAPER_BY_RULE[rule] ?? engine);
}

/** The name of a record's configuration; the engine's where nothing tells one. */
export const configuration_of = (record) => record.configuration || derived_of(record);

/** Sorted: this project's own first, in their order, then by name. */
export function ordered_configurations(names) {
  const place = (name) => {
    const own = OWN_CONFIGURATIONS.indexOf(name);
    return own < 0 ? OWN_CONFIGURATIONS.length : own;
  };
  return [...new Set(names)].sort((a, b) => place(a) - place(b) || (a < b ? -1 : a > b ? 1 : 0));
}
