// SPDX-License-Identifier: GPL-3.0-or-later
import { short_margin } from "../../model/check_text.js";
import {
  format_count,
  format_digits,
  format_seconds,
  format_short,
  format_value,
} from "../../model/number.js";
import { counted, VERDICTS } from "../../model/verdict.js";
import { h } from "../dom.js";
import { case_hash } from "../route.js";

const fact = (name, value, note, href) =>
  h(
    "div",
    { class: "fact" },
    h("dt", {}, name),
    h(
      "dd",
      {},
      h("span", { class: "fact-value" }, href ? h("a", { href }, value) : value),
      note && h("span", { class: "fact-note" }, note),
    ),
  );

/** What all records come to, in a row of figures. */
export function facts(tally, index) {
  const checks = index.check_counts;
  const total = Object.values(checks).reduce((a, b) => a + b, 0);
  return h(
    "dl",
    { class: "facts" },
    fact(
      "Checks",
      format_count(total),
      VERDICTS.filter((verdict) => checks[verdict] > 0)
        .map((verdict) => counted(verdict, checks[verdict], format_count(checks[verdict])))
        .join(", "),
    ),
    tally.closest &&
      fact(
        tally.closest.check.margin > 1
          ? "Furthest beyond its tolerance"
          : "Closest to its tolerance",
        short_margin(tally.closest.check.margin),
        tally.closest.case,
        case_hash(tally.closest.case),
      ),
    fact(
      "Fewest digits",
      Number.isFinite(tally.fewest) ? format_digits(tally.fewest) : "–",
      "of the deciding checks",
    ),
    fact(
      "CPU time",
      `${format_seconds(tally.seconds)} s`,
      [`${format_short(tally.steps)} steps`, tally.machines && `on ${tally.machines}`]
        .filter(Boolean)
        .join("; "),
    ),
    fact(
      "Contact update",
      tally.median_ns > 0 ? `${format_value(Number(tally.median_ns.toPrecision(3)))} ns` : "–",
      [`median; ${format_short(tally.updates)} updates`, tally.machines && `on ${tally.machines}`]
        .filter(Boolean)
        .join("; "),
    ),
  );
}
