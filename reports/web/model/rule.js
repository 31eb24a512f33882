// SPDX-License-Identifier: GPL-3.0-or-later
// What the variants of a comparison are called, in the words of its findings: a rule on contacts.

// Of a variant: whose contacts, and the rule itself. What else it sets are parameters of the rule.
const NO_PARAMETER = new Set(["method", "depth", "rule", "sweeps", "build"]);

// As build_words() there: "single precision"; "" for the engine as it is.
function build_words({ build }) {
  if (build === undefined) return "";
  return build === "single" ? "single precision" : `build ${build}`;
}

/**
 * As rule_words() in validation/comparison/comparison.cpp: "secant, memory = keep", "stored-vector, 4 sweeps". A
 * rule's own number of sweeps, which its variant does not set, is the most that it does.
 */
export const rule_words = (record) =>
  [reading_words(record), build_words(record.settings)].filter(Boolean).join(", ");

// Without the build in which it runs.
function reading_words({ variant = "", settings: { rule = "", sweeps } }) {
  const set = variant.split(" ").map((word) => word.split("="));
  const most = set.some(([name]) => name === "sweeps") ? "" : "at most ";
  return [
    rule,
    ...set
      .filter(([name, value]) => value !== undefined && !NO_PARAMETER.has(name))
      .map(([name, value]) => `${name} = ${value}`),
    sweeps !== undefined && `${most}${sweeps} sweeps`,
  ]
    .filter(Boolean)
    .join(", ");
}

/**
 * Each of some records as a rule on contacts: [{rule, words, name, contacts, label}]. `words` tell it from
 * the others on the same contacts, `name` does so in fewer letters. `run_of(index)` names a record's run, or nothing where there is one.
 */
export function rules_on_contacts(records, run_of = () => "") {
  // Contacts of one method that differ in their depth rule are told apart by it.
  const group = ({ case: name, settings }) => `${name}\n${settings.method}`;
  const depths = new Map();
  for (const record of records)
    depths.set(group(record), (depths.get(group(record)) ?? new Set()).add(record.settings.depth));
  const contacts_of = (record) =>
    [
      record.settings.method ?? "",
      depths.get(group(record)).size > 1 && `${record.settings.depth} depth`,
    ]
      .filter(Boolean)
      .join(", ");
  const told = records.map((record, i) => ({
    rule: record.settings.rule ?? record.engine,
    contacts: contacts_of(record),
    words: [rule_words(record) || record.engine, run_of(i)].filter(Boolean).join(", "),
  }));
  // A rule of one reading needs no more than its name in a picture, and the build that it runs in.
  const readings = new Map();
  told.forEach(({ rule }, i) => {
    const reading = [reading_words(records[i]), run_of(i)].join(", ");
    readings.set(rule, (readings.get(rule) ?? new Set()).add(reading));
  });
  const counts = new Map();
  return told.map((one, i) => {
    const key = `${records[i].case}\n${one.contacts}\n${one.words}`;
    counts.set(key, (counts.get(key) ?? 0) + 1);
    const words = counts.get(key) > 1 ? `${one.words} #${counts.get(key)}` : one.words;
    const short = [one.rule, build_words(records[i].settings)].filter(Boolean).join(", ");
    const name = readings.get(one.rule).size === 1 ? short : words;
    return { ...one, words, name, label: [words, one.contacts].filter(Boolean).join(" · ") };
  });
}
