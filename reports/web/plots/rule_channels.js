// SPDX-License-Identifier: GPL-3.0-or-later
// How the variants of a comparison look, the same in each of its plots: a colour for each rule, a dash
// for each of its readings, a filled mark on quiet contacts.
import { FIXED_POINT, NO_MEMORY, QUIET, SECANT } from "../model/configuration.js";
import { configuration_styles } from "./configuration_style.js";
import { numbered } from "./names.js";
import { SERIES_DASHES } from "./palette.js";

// The rules of this project's configurations have their colours.
const CONFIGURATIONS = {
  "conjugate-vector": QUIET,
  "fixed-point": FIXED_POINT,
  secant: SECANT,
  none: NO_MEMORY,
};

const cycled = (list, count) => Array.from({ length: count }, (_, i) => list[i % list.length]);

/**
 * For variants as rules_on_contacts() gives them: {keys_of(variant): {rule_key, reading_key,
 * contacts_key}, contacts, color, dash, named_color}; the last three are channels, only the last with a
 * legend.
 */
export function rule_channels(variants) {
  const rules = [...new Set(variants.map(({ rule }) => rule))].sort();
  const contacts = [...new Set(variants.map((one) => one.contacts))].sort();
  const readings = new Map(rules.map((rule) => [rule, []]));
  for (const { rule, words } of variants)
    if (!readings.get(rule).includes(words)) readings.get(rule).push(words);
  const most = Math.max(...[...readings.values()].map((list) => list.length));
  const named = rules.map((rule) =>
    Object.hasOwn(CONFIGURATIONS, rule) ? CONFIGURATIONS[rule] : rule,
  );
  const styles = configuration_styles(named);
  const colours = named.map((name) => styles.get(name).colour);
  const channel = (field, range, count) => ({
    field,
    type: "ordinal",
    scale: { domain: Array.from({ length: count }, (_, i) => i), range: cycled(range, count) },
    legend: null,
  });
  return {
    keys_of: ({ rule, words, contacts: on }) => ({
      rule_key: rules.indexOf(rule),
      reading_key: readings.get(rule).indexOf(words),
      contacts_key: contacts.indexOf(on),
    }),
    contacts,
    color: channel("rule_key", colours, rules.length),
    named_color: {
      ...channel("rule_key", colours, rules.length),
      legend: { labelExpr: numbered(rules).labels, symbolType: "stroke", symbolSize: 300 },
    },
    dash: channel("reading_key", SERIES_DASHES, most),
  };
}

/** "on quiet contacts"; nothing where there is one kind. */
export const on_contacts = (contacts) => (contacts ? ` on ${contacts} contacts` : "");
