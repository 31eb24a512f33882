// SPDX-License-Identifier: GPL-3.0-or-later
// The claims of a case: each with its formula, what was expected and from where, and why its tolerance is
// what it is. What came out stands in results_table.js.
import {
  causes_of,
  claims_of,
  expected_of,
  told,
  tolerance_of,
  worst_verdict,
} from "../../model/claim.js";
import { h } from "../dom.js";
import { glyph } from "../widgets/glyph.js";

const HEIGHTS = { line: 23, formula: 36, padding: 34, letters: 68 }; // px in half a page's width

const reason = (name, { value, why }) => [
  h("dt", {}, name),
  h("dd", {}, value && h("strong", {}, `${value}: `), why),
];

const LONG = 240; // letters; of more the first sentence stands alone until it is opened

function folded(text) {
  const end = text.slice(0, LONG).search(/(?<=[^\d\s]{2})[.:;] /);
  if (text.length <= LONG || end < 0) return h("div", {}, text);
  return h(
    "details",
    { class: "folded" },
    h("summary", {}, `${text.slice(0, end)} …`),
    h("div", {}, text.slice(end + 2)),
  );
}

function claim_section(group, chosen) {
  const [{ check }] = group;
  const verdict = worst_verdict(group);
  const places = told(group, "worst");
  const { causes, bands } = causes_of(group);
  return h(
    "article",
    { class: `claim verdict-${verdict}${check.quantity === chosen ? " chosen" : ""}` },
    h(
      "h3",
      {},
      glyph(verdict, 15),
      " ",
      h("span", { class: "claim-quantity" }, check.quantity),
      " ",
      h("span", { class: "claim-text" }, check.claim),
    ),
    check.formula && h("p", { class: "formula" }, check.formula),
    h(
      "dl",
      { class: "why" },
      reason("Expected", expected_of(group)),
      reason("Tolerance", tolerance_of(group)),
      causes.length > 0 && [h("dt", {}, "Cause"), h("dd", {}, causes.map(folded))],
      bands.length > 0 && [h("dt", {}, "Band"), h("dd", {}, bands.map(folded))],
      places !== "" && [h("dt", {}, "Worst place"), h("dd", {}, places)],
    ),
  );
}

/** `entries`: [{record, label}]; `chosen`: the quantity of a check that stands out. */
export const checks_section = (entries, chosen = "") =>
  claims_of(entries).map((group) => claim_section(group, chosen));

/** About how tall that is in half a page's width, px. */
export function checks_height(entries) {
  const lines = (text, letters = HEIGHTS.letters) =>
    HEIGHTS.line * Math.ceil(text.length / letters);
  return claims_of(entries).reduce((sum, group) => {
    const [{ check }] = group;
    return (
      sum +
      HEIGHTS.padding +
      lines(`${check.quantity} ${check.claim}`) +
      (check.formula ? HEIGHTS.formula : 0) +
      lines(check.source, 56) +
      lines(check.reason, 56) +
      lines(told(group, "worst"), 56) +
      2 * HEIGHTS.line * causes_of(group).causes.length
    );
  }, 0);
}
