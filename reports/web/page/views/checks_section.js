// SPDX-License-Identifier: GPL-3.0-or-later
// The claims of a case: each with its formula, its source, why its tolerance is what it is, and a
// table of what each variant measured.
import { band_text, expected_text, margin, tolerance_text } from "../../model/check_text.js";
import { group_by } from "../../model/family.js";
import { format_digits, format_error, format_pair, to_number } from "../../model/number.js";
import { rank } from "../../model/verdict.js";
import { h } from "../dom.js";
import { verdict_mark } from "../widgets/glyph.js";
import { margin_bar } from "../widgets/margin_bar.js";

const KINDS = {
  analytic: "closed form",
  "exact-computed": "computed exactly",
  "self-converged": "own refinement's limit",
  external: "published or measured elsewhere",
  golden: "an earlier result",
};

const HEIGHTS = { line: 23, formula: 36, row: 31, padding: 34, letters: 68 }; // px in half a page's width

const pair_of = (check) => format_pair(to_number(check.value), to_number(check.expected));
const tolerance_of = (check) => format_error(to_number(check.tolerance));

// The unit of a group stands in the heading. What all its variants share stands below the table.
const COLUMNS = [
  { name: "Measured", kind: "value", text: (check) => pair_of(check)[0] },
  { name: "Expected", kind: "value", text: (check) => pair_of(check)[1], shared: "expected" },
  { name: "Error", kind: "error", text: (check) => format_error(to_number(check.error)) },
  { name: "Tolerance", kind: "error", text: tolerance_of, shared: "tolerance" },
  {
    name: "Digits",
    kind: "",
    text: ({ digits }) => (digits === undefined ? "–" : format_digits(to_number(digits))),
  },
];

const is_shared = (group, field) =>
  group.every(({ check }) => check[field] === group[0].check[field]);

// As many digits as it takes to tell it from every measured value.
const expected_of = (group) =>
  group.map(({ check }) => expected_text(check)).reduce((a, b) => (b.length > a.length ? b : a));

function unit_of({ unit, relative }, kind) {
  if (kind === "") return "";
  if (kind === "error" && relative) return "relative";
  return unit === "1" ? "" : unit;
}

function check_row({ check, label }, columns, banded) {
  return h(
    "tr",
    {},
    h("td", {}, verdict_mark(check.verdict, 15)),
    label !== null && h("th", { scope: "row" }, label || "–"),
    h("td", {}, margin_bar(margin(check), true, check.verdict)),
    columns.map(({ text }) => h("td", { class: "number" }, text(check))),
    banded && h("td", { class: "band" }, band_text(check)),
  );
}

const told = (group, field) =>
  [...new Set(group.map(({ check }) => check[field]).filter(Boolean))].join("; ");

function claim_section(group, several) {
  const { check } = group[0];
  const worst = group.reduce((a, b) =>
    rank(b.check.verdict) < rank(a.check.verdict) ? b : a,
  ).check;
  const places = told(group, "worst");
  const causes = told(group, "cause");
  const banded = group.some(({ check: one }) => band_text(one) !== "");
  const columns = COLUMNS.filter(({ shared }) => !shared || !is_shared(group, shared));
  const expected = is_shared(group, "expected") && h("strong", {}, `${expected_of(group)}: `);
  const tolerance = is_shared(group, "tolerance") && h("strong", {}, `${tolerance_text(check)}: `);
  const heading = (name, number = false, unit = "") =>
    h(
      "th",
      { scope: "col", class: number ? "number" : "" },
      name,
      unit && h("span", { class: "unit" }, ` ${unit}`),
    );
  return h(
    "article",
    { class: `claim verdict-${worst.verdict}` },
    h(
      "h3",
      {},
      h("span", { class: "claim-quantity" }, check.quantity),
      " ",
      h("span", { class: "claim-text" }, check.claim),
    ),
    check.formula && h("p", { class: "formula" }, check.formula),
    h(
      "div",
      {
        class: "data-scroll",
        tabindex: "0",
        role: "region",
        "aria-label": `Results: ${check.quantity}`,
      },
      h(
        "table",
        { class: "checks" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            heading("Verdict"),
            several && heading("Variant"),
            heading("|Error| ÷ tolerance"),
            columns.map(({ name, kind }) => heading(name, true, unit_of(check, kind))),
            banded && heading("Band"),
          ),
        ),
        h(
          "tbody",
          {},
          group.map(({ check: one, label }) =>
            check_row({ check: one, label: several ? label : null }, columns, banded),
          ),
        ),
      ),
    ),
    h(
      "dl",
      { class: "why" },
      h("dt", {}, "Expected"),
      h("dd", {}, expected, `${check.source} (${KINDS[check.kind] ?? check.kind})`),
      h("dt", {}, "Tolerance"),
      h("dd", {}, tolerance, check.reason || "no reason given"),
      causes !== "" && [h("dt", {}, "Cause"), h("dd", {}, causes)],
      places !== "" && [h("dt", {}, "Worst place"), h("dd", {}, places)],
    ),
  );
}

// Groups of checks of the same claim, those that fail first.
function claims_of(entries) {
  const all = entries.flatMap(({ record, label }) =>
    record.checks.map((check) => ({ check, label })),
  );
  const groups = [
    ...group_by(all, ({ check }) =>
      JSON.stringify([check.quantity, check.unit, check.relative, check.claim, check.formula]),
    ).values(),
  ];
  const worst = (group) => Math.min(rank("pass"), ...group.map(({ check }) => rank(check.verdict)));
  return groups.sort((a, b) => worst(a) - worst(b));
}

/** `entries`: [{record, label}]. */
export const checks_section = (entries) =>
  claims_of(entries).map((group) => claim_section(group, entries.length > 1));

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
      HEIGHTS.row * (group.length + 1) +
      lines(check.source, 56) +
      lines(check.reason, 56) +
      lines(told(group, "worst"), 56) +
      lines(told(group, "cause"), 56)
    );
  }, 0);
}
