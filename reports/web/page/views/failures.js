// SPDX-License-Identifier: GPL-3.0-or-later
// What does not hold, worst first, each in one sentence.
import {
  band_text,
  error_text,
  expected_text,
  short_margin,
  tolerance_text,
  value_text,
} from "../../model/check_text.js";
import { h } from "../dom.js";
import { group_by } from "../../model/family.js";
import { is_bad, rank, VERDICT_WORDS } from "../../model/verdict.js";
import { glyph } from "../widgets/glyph.js";
import { margin_bar } from "../widgets/margin_bar.js";
import { case_hash, hash_of } from "../route.js";

const severity = (row) => row.check?.margin ?? Infinity;

const band_of = (check) => {
  const text = band_text(check);
  return text && `; ${text}`;
};

// The worst variant of a case stands for those that fail with it.
function failure([row, ...others]) {
  const { check } = row;
  const more = [row.label, others.length > 0 && `+ ${others.length} more`]
    .filter(Boolean)
    .join(" ");
  return h(
    "li",
    { class: `failure verdict-${row.verdict}` },
    h(
      "span",
      { class: "failure-glyph" },
      glyph(row.verdict, 16),
      h("span", { class: "sr" }, VERDICT_WORDS[row.verdict]),
    ),
    h(
      "p",
      { class: "failure-name" },
      h("a", { href: case_hash(row.case), title: `${row.case} ${row.variant}` }, row.case),
      more && h("span", { class: "variant" }, more),
    ),
    h(
      "p",
      { class: "failure-text" },
      row.verdict === "error" || !check
        ? `broke off: ${row.error || "no reason given"}`
        : [
            `${check.quantity} `,
            h("strong", {}, value_text(check)),
            ` instead of ${expected_text(check)}; error ${error_text(check)}, allowed ${tolerance_text(check)}${band_of(check)}`,
          ],
    ),
    h(
      "div",
      { class: "failure-margin" },
      check && [
        margin_bar(check.margin, false, row.verdict),
        h("span", {}, short_margin(check.margin)),
      ],
    ),
  );
}

/** Null when everything holds. */
export function failures_list(rows, most = 5) {
  const bad = rows
    .filter((row) => is_bad(row.verdict))
    .sort((a, b) => rank(a.verdict) - rank(b.verdict) || severity(b) - severity(a));
  if (bad.length === 0) return null;
  const cases = [...group_by(bad, (row) => row.case).values()];
  return h(
    "section",
    { class: "failures", "aria-labelledby": "failures-title" },
    h(
      "h2",
      { id: "failures-title" },
      cases.length === 1 ? "What does not hold" : "What does not hold, worst first",
    ),
    h("ol", {}, cases.slice(0, most).map(failure)),
    cases.length > most &&
      h(
        "p",
        {},
        h(
          "a",
          { href: hash_of("cases", "", { verdict: "error,fail", sort: "-margin" }) },
          `All ${bad.length} failures in ${cases.length} cases`,
        ),
      ),
  );
}
