// SPDX-License-Identifier: GPL-3.0-or-later
import { expected_text, value_text } from "../../model/check_text.js";
import { format_digits, format_seconds_short, format_value } from "../../model/number.js";
import { h } from "../dom.js";
import { machine_mark } from "../widgets/machine_mark.js";
import { style_mark } from "../widgets/style_mark.js";
import { margin_bar } from "../widgets/margin_bar.js";
import { verdict_mark } from "../widgets/glyph.js";
import { case_hash } from "../route.js";

/** The columns of the table of records; `runs` are named only where there are several. */
export function case_columns(runs) {
  const several = runs.filter(({ role }) => role === "shown").length > 1;
  const of_check = (cell) => (row) => (row.check ? cell(row.check) : "");
  return [
    {
      key: "verdict",
      label: "Verdict",
      class: "c-verdict",
      sortable: true,
      cell: (row) => verdict_mark(row.verdict),
    },
    {
      key: "case",
      label: "Case",
      class: "c-case",
      sortable: true,
      cell: (row) => [
        h("a", { href: case_hash(row.case), title: row.title || row.case }, row.case),
        h(
          "span",
          { class: "variant" },
          row.label === "" || row.label.startsWith(row.column) ? style_mark(row.column, 9) : "",
          " ",
          [several && runs[row.run].short, row.label || row.column, row.frames && "▶ recorded"]
            .filter(Boolean)
            .join(" · "),
        ),
      ],
    },
    {
      key: "quantity",
      label: "Quantity",
      class: "c-quantity",
      cell: (row) => row.check?.quantity ?? (row.error || ""),
    },
    {
      key: "value",
      label: "Measured, expected",
      class: "c-value number",
      cell: of_check((check) => [
        value_text(check),
        h("span", { class: "expected" }, expected_text(check)),
      ]),
    },
    {
      key: "margin",
      label: "|Error| ÷ tolerance",
      term: "of tolerance",
      class: "c-margin",
      sortable: true,
      cell: (row) => (row.check ? margin_bar(row.check.margin, true, row.verdict) : ""),
    },
    {
      key: "digits",
      label: "Digits",
      term: "digits",
      class: "c-digits number",
      sortable: true,
      cell: of_check(({ digits }) => (digits === null ? "–" : format_digits(digits))),
    },
    {
      key: "seconds",
      label: "CPU",
      term: "CPU time",
      unit: "s",
      class: "c-seconds number",
      sortable: true,
      cell: (row) => [format_seconds_short(row.seconds), machine_mark(row.machine)],
    },
    {
      key: "ns",
      label: "Contact",
      unit: "ns",
      class: "c-ns number",
      sortable: true,
      cell: (row) =>
        row.ns > 0 ? [format_value(Number(row.ns.toPrecision(3))), machine_mark(row.machine)] : "–",
    },
  ];
}
