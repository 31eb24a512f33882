// SPDX-License-Identifier: GPL-3.0-or-later
// What a comparison with earlier runs says on the screen, and by its exit code.
import { CHANGE_CLASSES, CHANGE_WORDS } from "../model/compare.js";

const MOST_TOLD = 10; // of a class, by name

const counted = (count, what) => `${count} ${what}${count === 1 ? "" : "s"}`;

// "slab/creep: pass → fail", "slab/creep: creep, -1.2 digits"
function line_of({ case: name, class: change, before, after, digits_change, quantity }) {
  const detail =
    change === "worse" || change === "better"
      ? `${before.verdict} → ${after.verdict}`
      : `${quantity}, ${digits_change > 0 ? "+" : ""}${digits_change.toFixed(1)} digits`;
  return `  ${CHANGE_WORDS[change]}  ${name}: ${detail}`;
}

/**
 * {text, code} of a comparison as page_data() gives it: code 0 when nothing got worse, 1 when a verdict or
 * the digits of a check did. CPU times are counted and decide nothing: two runs tell too little of them.
 * Throws when no case is in both.
 */
export function told_changes({ total, counts, changes }, earlier) {
  const count = (name) => counts[name] ?? 0;
  const paired = total - count("new") - count("gone");
  if (paired === 0)
    throw new Error(`no case of ${earlier} is in this run too: nothing is compared`);
  const verdicts = count("worse") + count("better");
  const lines = [
    `Against ${earlier}: ${counted(verdicts, "verdict")} changed, ${count("better")} better, ${count("worse")} worse, of ${paired} compared.`,
  ];
  const others = CHANGE_CLASSES.filter(
    (name) => !["worse", "better", "same"].includes(name) && count(name) > 0,
  ).map((name) => `${count(name)} ${CHANGE_WORDS[name]}`);
  if (others.length > 0) lines.push(`Besides: ${others.join(", ")}.`);
  for (const name of ["worse", "fewer-digits", "better"]) {
    const of_class = changes.filter((change) => change.class === name);
    lines.push(...of_class.slice(0, MOST_TOLD).map(line_of));
    if (count(name) > MOST_TOLD)
      lines.push(`  ${CHANGE_WORDS[name]}  … and ${count(name) - MOST_TOLD} more, in the page`);
  }
  return { text: lines.join("\n"), code: count("worse") + count("fewer-digits") > 0 ? 1 : 0 };
}
