// SPDX-License-Identifier: GPL-3.0-or-later
// One row a family: verdicts as a row of shapes, digits, cost. The plot beside it has the same rows.
import { group_by } from "../../model/family.js";
import { format_count, format_digits, format_seconds_short } from "../../model/number.js";
import { is_dense, overview_rows, row_height } from "../../model/overview.js";
import { rank, VERDICTS } from "../../model/verdict.js";
import { h, svg } from "../dom.js";
import { glyph, verdict_mark } from "../widgets/glyph.js";
import { case_hash, hash_of } from "../route.js";
import { tally_of } from "../tally.js";

const MOST_GLYPHS = 24;

const counts = (tally) =>
  h(
    "span",
    { class: "shape-counts" },
    VERDICTS.filter((verdict) => tally[verdict] > 0).map((verdict) =>
      h(
        "span",
        { class: `verdict verdict-${verdict}` },
        glyph(verdict, 13),
        format_count(tally[verdict]),
      ),
    ),
  );

// Each record a shape; beyond a row of them, or where there is no room, counts.
function shapes(rows, tally) {
  if (rows.length > MOST_GLYPHS) return counts(tally);
  const places = new Map();
  const drawn = rows.map((row) => {
    const shape = glyph(row.verdict, 11);
    places.set(shape, row);
    shape.append(svg("title", {}, `${row.case} ${row.label}`));
    return shape;
  });
  const open = (event) => {
    const row = places.get(event.target.closest("svg"));
    if (row) location.hash = case_hash(row.case);
  };
  return [h("span", { class: "shapes", onclick: open }, drawn), counts(tally)];
}

function family_row(name, rows) {
  const tally = tally_of(rows);
  const worst = rows.reduce((a, b) => (rank(b.verdict) < rank(a.verdict) ? b : a)).verdict;
  return h(
    "tr",
    { class: tally.bad > 0 ? "bad" : "" },
    h("td", { class: "f-verdict" }, verdict_mark(worst, 15)),
    h("th", { scope: "row" }, h("a", { href: hash_of("family", name) }, name)),
    h("td", { class: "f-shapes" }, shapes(rows, tally)),
    h(
      "td",
      { class: "number f-digits" },
      Number.isFinite(tally.fewest) ? format_digits(tally.fewest) : "–",
    ),
    h("td", { class: "number" }, format_seconds_short(tally.seconds)),
  );
}

export function family_table(rows) {
  const groups = [...group_by(rows, (row) => row.family)].map(([name, list]) => ({ name, list }));
  const shown = overview_rows(groups, ({ list }) => list.map(({ verdict }) => verdict));
  return h(
    "div",
    { class: "family-scroll", tabindex: "0", role: "region", "aria-label": "Families" },
    h(
      "table",
      {
        class: is_dense(shown.length) ? "families dense" : "families",
        style: { "--row": `${row_height(shown.length)}px` },
      },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("th", { scope: "col" }, "Verdict"),
          h("th", { scope: "col" }, "Family"),
          h("th", { scope: "col" }, "Records"),
          h("th", { scope: "col", class: "number f-digits" }, "Digits"),
          h("th", { scope: "col", class: "number" }, "CPU", h("span", { class: "unit" }, " s")),
        ),
      ),
      h(
        "tbody",
        {},
        shown.map(({ name, list }) => family_row(name, list)),
      ),
    ),
    groups.length > shown.length &&
      h(
        "p",
        {},
        h("a", { href: hash_of("cases") }, `${groups.length - shown.length} more families`),
      ),
  );
}
