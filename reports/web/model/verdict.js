// SPDX-License-Identifier: GPL-3.0-or-later
import { to_number } from "./number.js";

// Verdicts, worst first, each with the words that people read. Colour never stands alone: each has a
// shape of its own too (page/widgets/glyph.js, plots/verdict_scale.js).
export const VERDICTS = ["error", "fail", "expected-shortfall", "refuted", "pass", "for-information", "not-applicable"];

export const VERDICT_WORDS = {
  error: "broke off",
  fail: "fails",
  "expected-shortfall": "expected shortfall",
  refuted: "refuted",
  pass: "holds",
  "for-information": "for information",
  "not-applicable": "not applicable",
};

/** 0 for the worst. Unknown words come last. */
export function rank(verdict) {
  const place = VERDICTS.indexOf(verdict);
  return place < 0 ? VERDICTS.length : place;
}

export const is_bad = (verdict) => verdict === "error" || verdict === "fail";

/** Does not meet its claim, in a band that was stated beforehand. */
export const is_expected = (verdict) => verdict === "expected-shortfall" || verdict === "refuted";

/** Whether a verdict says something of the value. */
export const is_decided = (verdict) =>
  verdict === "pass" || verdict === "fail" || is_expected(verdict);

/**
 * The digits of a record, as fewest_digits() in reports/record/record.h: fewest of its checks that pass
 * or fail and have any; null when none has.
 */
export function fewest_digits({ checks }) {
  const digits = checks
    .filter(({ verdict, digits: own }) => (verdict === "pass" || verdict === "fail") && own !== undefined)
    .map((check) => to_number(check.digits));
  return digits.length > 0 ? digits.reduce((a, b) => (b >= a ? a : b)) : null;
}

/** The check that decides, as worst_check() in reports/record/judgement.h; undefined when none does. */
export function worst_check(checks, margin) {
  let worst;
  for (const check of checks) {
    if (rank(check.verdict) > rank("pass")) continue;
    if (
      worst === undefined ||
      rank(check.verdict) < rank(worst.verdict) ||
      (check.verdict === worst.verdict && margin(check) > margin(worst))
    ) {
      worst = check;
    }
  }
  return worst;
}

const COUNTED = {
  fail: ["fails", "fail"],
  "expected-shortfall": ["expected shortfall", "expected shortfalls"],
  pass: ["holds", "hold"],
};

/** "1 fails", "33 expected shortfalls"; `number` is the count as it shall be spelled. */
export function counted(verdict, count, number = String(count)) {
  const word = VERDICT_WORDS[verdict];
  return `${number} ${(COUNTED[verdict] ?? [word, word])[count === 1 ? 0 : 1]}`;
}
