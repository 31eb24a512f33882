// SPDX-License-Identifier: GPL-3.0-or-later
// Two runs side by side: what changed in verdicts, digits and cost.
import { is_decided, rank } from "./verdict.js";
import { to_number } from "./number.js";
import { group_by } from "./family.js";
import { natural_sort } from "./natural.js";
import { variant_key } from "./variant.js";

/** A change of fewer digits than this is noise. */
export const DIGITS_NOISE = 0.1;

const decided = (check) => is_decided(check.verdict);

// An error below a thousandth of its tolerance decides nothing.
const NEGLIGIBLE = 3;

// Digits of a check; where zero is expected of a quantity without a scale, how many powers of ten its
// error is below its tolerance. As digits_of() in benchmarks/track/decide/accuracy.cpp.
const precision = (check) =>
  check.digits === undefined
    ? Math.max(-Infinity, Math.min(NEGLIGIBLE, -Math.log10(to_number(check.of_tolerance))))
    : to_number(check.digits);

// The check whose digits changed most: {change, quantity}.
function digits_change(before, after) {
  const earlier = new Map(
    before.checks.filter(decided).map((check) => [check.quantity, precision(check)]),
  );
  let most = { change: 0, quantity: "" };
  for (const check of after.checks.filter(decided)) {
    const change = precision(check) - earlier.get(check.quantity);
    if (Math.abs(change) > Math.abs(most.change)) most = { change, quantity: check.quantity };
  }
  return most;
}

function class_of(before, after, digits) {
  if (!before) return "new";
  if (!after) return "gone";
  const verdicts = rank(after.verdict) - rank(before.verdict);
  if (verdicts !== 0) return verdicts < 0 ? "worse" : "better";
  if (Math.abs(digits) <= DIGITS_NOISE) return "same";
  return digits < 0 ? "fewer-digits" : "more-digits";
}

/** Worst first. */
export const CHANGE_CLASSES = [
  "worse",
  "gone",
  "fewer-digits",
  "better",
  "more-digits",
  "new",
  "same",
];

export const CHANGE_WORDS = {
  worse: "verdict worse",
  gone: "gone",
  "fewer-digits": "fewer digits",
  better: "verdict better",
  "more-digits": "more digits",
  new: "new",
  same: "unchanged",
};

/**
 * Pairs records by case, engine and settings. Gives [{case, class, before, after, digits_change,
 * quantity, cost_ratio, hash_equal}], worst first; `before` and `after` are records or null.
 */
export function compare(before_records, after_records) {
  const key = (record) => `${record.case}\n${variant_key(record)}`;
  const before = group_by(before_records, key);
  const after = group_by(after_records, key);
  const names = natural_sort([...new Set([...after.keys(), ...before.keys()])], (name) =>
    name.slice(0, name.indexOf("\n")),
  );
  const changes = names.map((name) => {
    const [old_one, new_one] = [before.get(name)?.at(-1) ?? null, after.get(name)?.at(-1) ?? null];
    const digits =
      old_one && new_one ? digits_change(old_one, new_one) : { change: 0, quantity: "" };
    const ratio =
      old_one && new_one
        ? to_number(new_one.cost.cpu_seconds) / to_number(old_one.cost.cpu_seconds)
        : NaN;
    return {
      case: (new_one ?? old_one).case,
      class: class_of(old_one, new_one, digits.change),
      before: old_one,
      after: new_one,
      digits_change: digits.change,
      quantity: digits.quantity,
      cost_ratio: Number.isFinite(ratio) ? ratio : null,
      hash_equal:
        old_one && new_one && old_one.state_hash !== ""
          ? old_one.state_hash === new_one.state_hash
          : null,
    };
  });
  return changes.sort((a, b) => CHANGE_CLASSES.indexOf(a.class) - CHANGE_CLASSES.indexOf(b.class));
}
