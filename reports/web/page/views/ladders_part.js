// SPDX-License-Identifier: GPL-3.0-or-later
// How far each ladder holds: ladder × configuration, then each ladder's plot beside what breaks it.
import { VERDICT_WORDS } from "../../model/verdict.js";
import { h } from "../dom.js";
import { case_hash, hash_of } from "../route.js";
import { command } from "../widgets/command.js";
import { glyph } from "../widgets/glyph.js";
import { plot_figure } from "../widgets/plot_figure.js";
import { style_mark } from "../widgets/style_mark.js";

const interval = ({ lowest, highest }) =>
  lowest.text === highest.text ? lowest.text : `${lowest.text} … ${highest.text}`;

const broken_of = ({ below, above }) => [below, above].filter(Boolean);

// "2 … 10, not 20".
function span_mark(row) {
  if (row.decided === 0) return h("span", { class: "none" }, row.lacking > 0 ? "n/a" : "·");
  const broken = broken_of(row);
  const verdict = broken[0]?.verdict ?? "pass";
  const words = row.lowest ? interval(row) : "none";
  return h(
    "span",
    { class: "span-mark" },
    h("span", { class: `verdict-${verdict}` }, glyph(verdict, 12)),
    h("span", { class: "sr" }, ` ${VERDICT_WORDS[verdict]}:`),
    ` ${words}`,
    broken.length > 0 && h("strong", {}, `, not ${broken.map(({ text }) => text).join(", ")}`),
  );
}

const place_of = (ladder) => hash_of("stability", ladder.key);

/** Ladder × configuration in short. */
export const ladders_table = ({ names, ladders }) =>
  h(
    "div",
    { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "How far ladders hold" },
    h(
      "table",
      { class: "ladders" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("th", { scope: "col" }, "Ladder"),
          h("th", { scope: "col" }, "Parameter"),
          names.map(({ name, configuration }) =>
            h("th", { scope: "col" }, style_mark(configuration), " ", name),
          ),
        ),
      ),
      h(
        "tbody",
        {},
        ladders.map((ladder) =>
          h(
            "tr",
            {},
            h(
              "th",
              { scope: "row" },
              h("a", { href: place_of(ladder), title: ladder.title }, ladder.ladder),
            ),
            h("td", {}, ladder.parameter),
            names.map(({ name }) => {
              const row = ladder.rows.find((one) => one.name === name);
              return h("td", {}, row ? span_mark(row) : h("span", { class: "none" }, "·"));
            }),
          ),
        ),
      ),
    ),
  );

const rung_link = (rung) => h("a", { href: case_hash(rung.case), title: rung.case }, rung.text);

const failure_cell = (broken) =>
  h(
    "td",
    {},
    broken.failure || VERDICT_WORDS[broken.verdict],
    broken.recorded && [" ", h("a", { href: case_hash(broken.case) }, "▶ picture")],
    command(broken.command, broken.case),
  );

const notes_of = ({ beyond, lacking }) =>
  [
    beyond > 0 &&
      `${beyond} rung${beyond === 1 ? "" : "s"} beyond hold${beyond === 1 ? "s" : ""} again`,
    lacking > 0 && `${lacking} not applicable`,
  ]
    .filter(Boolean)
    .join("; ");

function configuration_rows(row) {
  const broken = broken_of(row);
  const lines = broken.length > 0 ? broken : [null];
  return lines.map((end, i) => {
    const good = end === row.below && row.lowest ? row.lowest : row.highest;
    return h(
      "tr",
      {},
      i === 0 &&
        h(
          "th",
          { scope: "row", rowspan: lines.length },
          style_mark(row.configuration),
          ` ${row.name}`,
          h("span", { class: "row-note" }, notes_of(row)),
        ),
      h(
        "td",
        { class: "rung", "data-head": "last good" },
        end ? (row.lowest ? rung_link(good) : "none") : span_mark(row),
      ),
      end
        ? [
            h(
              "td",
              { class: "rung", "data-head": "first bad" },
              glyph(end.verdict, 12),
              " ",
              rung_link(end),
            ),
            failure_cell(end),
          ]
        : [
            h("td", { class: "rung", "data-head": "first bad" }, row.decided > 0 ? "none" : "–"),
            h("td", {}, row.highest && command(row.highest.command, row.highest.case)),
          ],
    );
  });
}

/** One ladder: `plot` where it has one; `chosen` when it was asked for. */
export const ladder_section = (ladder, plot, chosen) =>
  h(
    "section",
    { class: `ladder${chosen ? " chosen" : ""}`, "aria-label": `Ladder ${ladder.key}` },
    h(
      "h3",
      {},
      h("a", { href: hash_of("family", ladder.family) }, ladder.ladder),
      h("span", { class: "variant" }, ladder.title),
    ),
    h("div", { class: "ladder-plot" }, plot && plot_figure({ ...plot, title: "" })),
    h(
      "div",
      {
        class: "data-scroll",
        tabindex: "0",
        role: "region",
        "aria-label": `Rungs of ${ladder.key}`,
      },
      h(
        "table",
        { class: "rungs" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            [
              "Configuration",
              "Last good rung",
              "First bad rung",
              "What fails, and how to run it again",
            ].map((words) => h("th", { scope: "col" }, words)),
          ),
        ),
        h("tbody", {}, ladder.rows.map(configuration_rows)),
      ),
    ),
  );
