// SPDX-License-Identifier: GPL-3.0-or-later

/** As family_name() in reports/text/family.h: the path before the first parameter, at most two parts. */
export function family_name(case_name) {
  const first = case_name.indexOf("/");
  if (first < 0) return case_name;
  const second = case_name.indexOf("/", first + 1);
  const two = second < 0 ? case_name : case_name.slice(0, second);
  return two.includes("=", first) ? case_name.slice(0, first) : two;
}

/** The case name behind the family's. */
export function short_name(case_name) {
  const family = family_name(case_name);
  return case_name.startsWith(family + "/") ? case_name.slice(family.length + 1) : case_name;
}

/** Map from key_of(item) to the items, in order of appearance. */
export function group_by(items, key_of) {
  const groups = new Map();
  for (const item of items) {
    const key = key_of(item);
    const group = groups.get(key);
    if (group) group.push(item);
    else groups.set(key, [item]);
  }
  return groups;
}
