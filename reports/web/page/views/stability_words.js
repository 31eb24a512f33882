// SPDX-License-Identifier: GPL-3.0-or-later
import { format_count } from "../../model/number.js";

const all_of = (count, total) =>
  count === total
    ? `all ${format_count(total)}`
    : `${format_count(count)} of ${format_count(total)}`;

const plural = (count, word) => `${word}${count === 1 ? "" : "s"}`;

/** What the counts of make/stability.mjs come to: sentences without an end. */
export function stability_sentences({ configurations, cases, kept, ladders, whole }) {
  return [
    cases > 0 &&
      `${all_of(kept, cases)} perturbed ${plural(cases, "case")} ${kept === 1 ? "keeps its" : "keep their"} digits`,
    ladders > 0 &&
      `${all_of(whole, ladders)} ${plural(ladders, "ladder")} ${whole === 1 ? "holds" : "hold"} on every rung`,
    configurations > 1 && `each of ${configurations} configurations counts`,
  ].filter(Boolean);
}
