// SPDX-License-Identifier: GPL-3.0-or-later
// What the variants of a comparison are called, in the words of its findings: a rule on contacts.

const DEFAULT_GAIN = 0.7; // FrictionParameters::gain

/** As rule_words() in validation/comparison/comparison.cpp: "secant, raw", "stored-vector, 4 sweeps". */
export function rule_words({ rule = "", gain, alpha, sweeps, memory, safeguard }) {
  const most = rule === "conjugate-vector" ? "at most " : "";
  return [
    rule,
    gain !== undefined && Number(gain) !== DEFAULT_GAIN && `g = ${gain}`,
    alpha !== undefined && `α = ${alpha} s/m`,
    sweeps !== undefined && `${most}${sweeps} sweeps`,
    memory === "keep" && "kept on slip",
    safeguard === "off" && "raw",
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
    words: [rule_words(record.settings) || record.engine, run_of(i)].filter(Boolean).join(", "),
  }));
  // A rule of one reading needs no more than its name in a picture.
  const readings = new Map();
  for (const { rule, words } of told)
    readings.set(rule, (readings.get(rule) ?? new Set()).add(words));
  const counts = new Map();
  return told.map((one, i) => {
    const key = `${records[i].case}\n${one.contacts}\n${one.words}`;
    counts.set(key, (counts.get(key) ?? 0) + 1);
    const words = counts.get(key) > 1 ? `${one.words} #${counts.get(key)}` : one.words;
    const name = readings.get(one.rule).size === 1 ? one.rule : words;
    return { ...one, words, name, label: [words, one.contacts].filter(Boolean).join(" · ") };
  });
}
