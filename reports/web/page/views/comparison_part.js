// SPDX-License-Identifier: GPL-3.0-or-later
// A case of a comparison: the figures side by side, the pictures in pairs, then what had to hold.
import { failed_in_part, failure_of, failure_text } from "../../model/figure.js";
import { is_bad } from "../../model/verdict.js";
import { checks_section } from "./checks_section.js";
import { h } from "../dom.js";
import { figures_table } from "./figures_table.js";

// Closed while it holds for every variant: then one line says all.
function judged_part(entries) {
  const judged = entries.filter(({ record }) => record.checks.length > 0);
  if (judged.length === 0) return null;
  const bad = judged.filter(({ record }) => record.checks.some(({ verdict }) => is_bad(verdict)));
  return h(
    "details",
    { class: "judged", open: bad.length > 0 },
    h(
      "summary",
      {},
      bad.length > 0
        ? `What must hold fails for ${bad.length} of ${judged.length}`
        : `What must hold, holds for all ${judged.length}: ${judged[0].record.checks[0].claim}`,
    ),
    checks_section(judged),
  );
}

function notes_part(entries) {
  const notes = entries.flatMap(({ record, label }) =>
    [...record.failures.filter(({ values }) => values.length > 0).map(failure_text), ...record.notes].map(
      (note) => h("li", {}, h("strong", {}, `${label}: `), note),
    ),
  );
  return notes.length > 0 && h("div", { class: "notes" }, h("h2", {}, "Notes"), h("ul", {}, notes));
}

function fail_words(failed, in_part) {
  const words = [
    failed > 0 && `✕ ${failed} fail${failed === 1 ? "s" : ""}`,
    in_part > 0 && `✕ ${in_part} fail${in_part === 1 ? "s" : ""} at some values`,
  ].filter(Boolean);
  return words.join(", ") || "none fails";
}

/** How many were compared and how many failed: in a comparison no verdict says so. */
export function compared_mark(records) {
  const failed = records.filter((record) => failure_of(record) !== "").length;
  const in_part = records.filter(failed_in_part).length;
  return h(
    "span",
    { class: `verdict verdict-${failed + in_part > 0 ? "fail" : "for-information"}` },
    failed === records.length
      ? `✕ all ${failed} fail`
      : `${records.length} side by side, ${fail_words(failed, in_part)}`,
  );
}

/** `entries`: [{record, label, variant}]; `figures`: the case's plots as elements. */
export const comparison_part = (entries, figures) => [
  h("h2", {}, "Side by side"),
  figures_table(entries),
  h("div", { class: "plot-pairs" }, figures),
  notes_part(entries),
  judged_part(entries),
];
