// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of a manual: one a case, or one for cases that differ in parameters alone.
import { group_by } from "../model/family.js";
import { natural_sort } from "../model/natural.js";

const LEAST_TOGETHER = 3; // cases that differ in parameters alone and share a page

// "incline/threshold/mu=0.3/azimuth=0" → "incline/threshold/mu=*/azimuth=*"
const pattern_of = (name) =>
  name
    .split("/")
    .map((part) => (part.includes("=") ? part.replace(/=.*$/, "=*") : part.replace(/^\d+%$/, "*")))
    .join("/");

/** What tells a case from the others of its page: its parameters. */
export const parameters_of = (name, pattern) => {
  const parts = pattern.split("/");
  return name
    .split("/")
    .filter((part, i) => part !== parts[i])
    .join(", ");
};

/** Pages in order: [{name, cases: [names], entries: [{record, run}]}]. */
export function pages_of(entries) {
  const by_case = group_by(entries, ({ record }) => record.case);
  const names = natural_sort([...by_case.keys()], (name) => name);
  const patterns = group_by(names, pattern_of);
  const pages = [];
  const done = new Set();
  for (const name of names) {
    if (done.has(name)) continue;
    const alike = patterns.get(pattern_of(name));
    const together = alike.length >= LEAST_TOGETHER;
    const cases = together ? alike : [name];
    for (const one of cases) done.add(one);
    pages.push({
      name: together ? pattern_of(name) : name,
      cases,
      entries: cases.flatMap((one) => by_case.get(one)),
    });
  }
  return pages;
}
