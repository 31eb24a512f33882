// SPDX-License-Identifier: GPL-3.0-or-later
// What came out: of each claim a row a configuration. What all rows have in common is said once above.
import { band_text, margin } from "../../model/check_text.js";
import { claims_of, is_banded } from "../../model/claim.js";
import { configuration_of } from "../../model/configuration.js";
import {
  format_digits,
  format_error,
  format_pair,
  name_with_unit,
  to_number,
} from "../../model/number.js";
import { h } from "../dom.js";
import { margin_bar } from "../widgets/margin_bar.js";
import { style_mark } from "../widgets/style_mark.js";
import { term } from "../widgets/term.js";
import { verdict_mark } from "../widgets/glyph.js";

/** A record's configuration: its mark and what it is called beside the others of its case. */
export const configuration_name = ({ record, label }) => [
  style_mark(configuration_of(record)),
  " ",
  label || configuration_of(record),
];

const number = (text) => h("td", { class: "number" }, text);

function result_cells(check, banded) {
  const [value, expected] = format_pair(to_number(check.value), to_number(check.expected));
  const unit = check.relative ? " rel" : "";
  const { digits } = check;
  return [
    h("td", {}, verdict_mark(check.verdict, 15)),
    number(value),
    number(expected),
    number(`${format_error(to_number(check.error))}${unit}`),
    number(`${format_error(to_number(check.tolerance))}${unit}`),
    h("td", {}, margin_bar(margin(check), true, check.verdict)),
    number(digits === undefined ? "–" : format_digits(to_number(digits))),
    banded && h("td", { class: "band" }, band_text(check)),
  ];
}

const quantity_of = ({ quantity, unit }) => name_with_unit(quantity, unit);

function claim_rows(group, banded, several) {
  if (!several)
    return group.map(({ check }) =>
      h("tr", {}, h("th", { scope: "row" }, quantity_of(check)), result_cells(check, banded)),
    );
  const columns = banded ? 9 : 8;
  return h(
    "tbody",
    {},
    h(
      "tr",
      { class: "quantity" },
      h("th", { scope: "rowgroup", colspan: columns }, quantity_of(group[0].check)),
    ),
    group.map((entry) =>
      h(
        "tr",
        {},
        h("th", { scope: "row" }, configuration_name(entry)),
        result_cells(entry.check, banded),
      ),
    ),
  );
}

// What all records set, and what only some do.
function settings_of(entries) {
  const all = entries.map(({ record }) => record.settings);
  const names = [...new Set(all.flatMap((settings) => Object.keys(settings)))];
  const shared = names.filter((name) => all.every((settings) => settings[name] === all[0][name]));
  return { shared, different: names.filter((name) => !shared.includes(name)) };
}

const pairs = (names, settings) =>
  names
    .filter((name) => settings[name] !== undefined)
    .map((name) => `${name} = ${settings[name]}`)
    .join(", ");

function settings_part(entries) {
  const { shared, different } = settings_of(entries);
  const common = pairs(shared, entries[0].record.settings);
  if (common === "" && different.length === 0) return null;
  return h(
    "details",
    { class: "settings" },
    h("summary", {}, "Settings"),
    common !== "" && h("p", {}, h("strong", {}, entries.length > 1 ? "Of all: " : ""), common, "."),
    different.length > 0 &&
      h(
        "dl",
        { class: "why" },
        entries.map((entry) => [
          h("dt", {}, configuration_name(entry)),
          h("dd", {}, pairs(different, entry.record.settings) || "–"),
        ]),
      ),
  );
}

/** `entries`: [{record, label}]. */
export function results_part(entries) {
  const claims = claims_of(entries);
  const several = entries.length > 1;
  const banded = claims.some(is_banded);
  const heading = (content, is_number = false) =>
    h("th", { scope: "col", class: is_number ? "number" : "" }, content);
  const rows = claims.map((group) => claim_rows(group, banded, several));
  return [
    claims.length > 0 &&
      h(
        "div",
        { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "Results" },
        h(
          "table",
          { class: "checks results" },
          h(
            "thead",
            {},
            h(
              "tr",
              {},
              heading(several ? term("configuration", "Configuration") : "Quantity"),
              heading("Verdict"),
              heading("Measured", true),
              heading("Expected", true),
              heading("Error", true),
              heading("Tolerance", true),
              heading(term("of tolerance", "|Error| ÷ tolerance")),
              heading(term("digits", "Digits"), true),
              banded && heading("Band"),
            ),
          ),
          several ? rows : h("tbody", {}, rows),
        ),
      ),
    settings_part(entries),
  ];
}
