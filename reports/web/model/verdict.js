// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts, worst first, each with the words that people read. Colour never stands alone: each has a
// shape of its own too (page/glyph.js, plots/verdict_scale.js).
export const VERDICTS = ["error", "fail", "limit", "refuted", "pass", "shown", "not-applicable"];

export const VERDICT_WORDS = {
  error: "broke off",
  fail: "fails",
  limit: "known limit",
  refuted: "refuted",
  pass: "holds",
  shown: "shown only",
  "not-applicable": "not applicable",
};

/** 0 for the worst. Unknown words come last. */
export function rank(verdict) {
  const place = VERDICTS.indexOf(verdict);
  return place < 0 ? VERDICTS.length : place;
}

export const is_bad = (verdict) => verdict === "error" || verdict === "fail";

/** Does not meet its claim, in a band that was stated beforehand. */
export const is_expected = (verdict) => verdict === "limit" || verdict === "refuted";

/** Whether a verdict says something of the value, so that its digits count. */
export const is_decided = (verdict) =>
  verdict === "pass" || verdict === "fail" || is_expected(verdict);

/** The check that decides, as worst_check() in reports/record/record.h; undefined when none does. */
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
  limit: ["known limit", "known limits"],
  pass: ["holds", "hold"],
};

/** "1 fails", "33 known limits"; `number` is the count as it shall be spelled. */
export function counted(verdict, count, number = String(count)) {
  const word = VERDICT_WORDS[verdict];
  return `${number} ${(COUNTED[verdict] ?? [word, word])[count === 1 ? 0 : 1]}`;
}
