// SPDX-License-Identifier: GPL-3.0-or-later
// What tells records of the same case apart: the run, the engine, its configuration and settings.
import { configuration_of } from "./configuration.js";

/** Every attribute of a record that can differ between variants. `run` is its run's short name. */
export function attributes_of(record, run = "") {
  return {
    run,
    engine: record.engine,
    configuration: configuration_of(record),
    ...record.settings,
  };
}

/** A key of engine and settings: the same in two runs of the same variant. */
export function variant_key(record) {
  const settings = Object.entries(record.settings).sort();
  return [record.engine, ...settings.map(([name, value]) => `${name}=${value}`)].join(" ");
}

// What people call a variant by, most telling first; these need no "name=".
const TELLING = ["run", "engine", "configuration", "method", "rule"];

const place_of = (name) => (TELLING.includes(name) ? TELLING.indexOf(name) : TELLING.length);

/**
 * One label for each of a list of attributes: as little of what differs as tells those of a group
 * apart, e.g. "paper · secant" or "dt=0.001". Empty when there is nothing to tell apart. Without
 * `group_of(index)` all are one group.
 */
export function variant_labels(list, group_of = () => "") {
  const value = (one, name) => one[name] ?? "";
  const names = [...new Set(list.flatMap((attributes) => Object.keys(attributes)))]
    .filter((name) => list.some((one) => value(one, name) !== value(list[0], name)))
    .sort((a, b) => place_of(a) - place_of(b));
  let known = list.map((_, i) => String(group_of(i))); // of each, as far as the labels tell
  let said = list.map(() => ""); // the same whatever the group
  let labels = list.map(() => []);
  for (const name of names) {
    const more = known.map((key, i) => `${key}\n${value(list[i], name)}`);
    if (new Set(more).size === new Set(known).size) continue;
    known = more;
    const values = new Map();
    list.forEach((one, i) =>
      values.set(said[i], (values.get(said[i]) ?? new Set()).add(value(one, name))),
    );
    list.forEach((one, i) => {
      // Left out where what was said before implies it: "quiet" needs no rule.
      if (value(one, name) === "" || values.get(said[i]).size === 1) return;
      labels[i].push(TELLING.includes(name) ? value(one, name) : `${name}=${value(one, name)}`);
    });
    said = said.map((text, i) => `${text}\n${value(list[i], name)}`);
  }
  const counts = new Map();
  const place = known.map((key) => counts.set(key, (counts.get(key) ?? 0) + 1).get(key));
  return labels.map((words, i) =>
    [...words, ...(counts.get(known[i]) > 1 ? [`#${place[i]}`] : [])].join(" · "),
  );
}
