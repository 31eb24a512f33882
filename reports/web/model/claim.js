// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of a case's records by what they claim, for the page and for the manual.
import { band_text, expected_text, tolerance_text } from "./check_text.js";
import { group_by } from "./family.js";
import { rank } from "./verdict.js";

const KINDS = {
  analytic: "closed form",
  "exact-computed": "computed exactly",
  "self-converged": "own refinement's limit",
  external: "published or measured elsewhere",
  golden: "an earlier result",
};

const claim_key = ({ quantity, unit, relative, claim, formula }) =>
  JSON.stringify([quantity, unit, relative, claim, formula]);

/**
 * Checks of the same claim together, those that fail first: [[{check, …entry}]] of `entries` {record, …},
 * whose other fields each check keeps.
 */
export function claims_of(entries) {
  const all = entries.flatMap((entry) => entry.record.checks.map((check) => ({ ...entry, check })));
  const groups = [...group_by(all, ({ check }) => claim_key(check)).values()];
  const worst = (group) => Math.min(rank("pass"), ...group.map(({ check }) => rank(check.verdict)));
  return groups.sort((a, b) => worst(a) - worst(b));
}

/** The verdict of a group of checks that decides. */
export const worst_verdict = (group) =>
  group.map(({ check }) => check.verdict).reduce((a, b) => (rank(b) < rank(a) ? b : a));

/** What the checks of a group say in a field, each text once. */
export const told = (group, field) =>
  [...new Set(group.map(({ check }) => check[field]).filter(Boolean))].join("; ");

const BAND = /^(.*?)\s*\(band: (.*)\)$/s;

/** The causes of a group's shortfalls, and by what rules their bands were drawn, each text once. */
export function causes_of(group) {
  const causes = [...new Set(group.map(({ check }) => check.cause).filter(Boolean))];
  const parts = causes.map((cause) => BAND.exec(cause)?.slice(1) ?? [cause, ""]);
  const once = (place) => [...new Set(parts.map((part) => part[place]).filter(Boolean))];
  return { causes: once(0), bands: once(1) };
}

const is_shared = (group, field) =>
  group.every(({ check }) => check[field] === group[0].check[field]);

/** What was expected and why: {value, why}; no `value` where it differs between the checks. */
export function expected_of(group) {
  const [{ check }] = group;
  const value = group
    .map(({ check: one }) => expected_text(one)) // as many digits as tell it from every measured value
    .reduce((a, b) => (b.length > a.length ? b : a));
  return {
    value: is_shared(group, "expected") ? value : "",
    why: `${check.source} (${KINDS[check.kind] ?? check.kind})`,
  };
}

/** The same of the tolerance. */
export function tolerance_of(group) {
  const [{ check }] = group;
  return {
    value: is_shared(group, "tolerance") ? tolerance_text(check) : "",
    why: check.reason || "no reason given",
  };
}

/** Whether any check of a group has a band to tell of. */
export const is_banded = (group) => group.some(({ check }) => band_text(check) !== "");
