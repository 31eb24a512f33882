// SPDX-License-Identifier: GPL-3.0-or-later
// What holds, what doesn't, by how much, at what cost: one screen.
import { group_by } from "../../model/family.js";
import { format_count } from "../../model/number.js";
import { counted, rank, VERDICTS } from "../../model/verdict.js";
import { compared_headline, compared_parts } from "./compared_part.js";
import { engines_headline, engines_parts, engines_subline } from "./engines_part.js";
import { h } from "../dom.js";
import { facts } from "./facts.js";
import { failures_list } from "./failures.js";
import { matrix } from "./matrix.js";
import { glyph } from "../widgets/glyph.js";
import { machines_note } from "../widgets/machine_mark.js";
import { style_mark } from "../widgets/style_mark.js";
import { plot_figure } from "../widgets/plot_figure.js";
import { stability_sentences } from "./stability_words.js";
import { plots_of_family } from "../records.js";
import { case_hash, hash_of } from "../route.js";
import { tally_of } from "../tally.js";

const plural = (count, one, many = `${one}s`) =>
  `${format_count(count)} ${count === 1 ? one : many}`;

const has_history = ({ families }) =>
  families.some(({ plots }) => plots.some(({ kind }) => kind === "trend"));

function headline(tally, index) {
  if (tally["not-applicable"] === tally.records && has_history(index))
    return ["for-information", "Measured over runs, and judged by nobody."];
  const expected = tally["expected-shortfall"] + tally.refuted;
  if (tally.bad === 0 && tally.pass === 0 && expected === 0)
    return ["for-information", "Nothing was decided."];
  if (tally.bad === 0 && tally["expected-shortfall"] + tally.refuted > 0) {
    const parts = [
      `${format_count(tally.pass)} hold${tally.pass === 1 ? "s" : ""}`,
      tally["expected-shortfall"] > 0 &&
        `${format_count(tally["expected-shortfall"])} fall${tally["expected-shortfall"] === 1 ? "s" : ""} short as expected`,
      tally.refuted > 0 && `${format_count(tally.refuted)} refuted`,
    ];
    return ["pass", `Nothing fails: ${parts.filter(Boolean).join(", ")}.`];
  }
  if (tally.bad === 0)
    return [
      "pass",
      tally.pass === 1 ? "The one record holds." : `All ${format_count(tally.pass)} records hold.`,
    ];
  const verdict = tally.error > 0 ? "error" : "fail";
  const parts = [
    tally.fail > 0 && `${format_count(tally.fail)} ${tally.fail === 1 ? "fails" : "fail"}`,
    tally.error > 0 && `${format_count(tally.error)} broke off`,
  ];
  return [
    verdict,
    `${parts.filter(Boolean).join(", ")}, ${format_count(tally.pass)} hold${tally.pass === 1 ? "s" : ""}.`,
  ];
}

function change_line(comparison) {
  if (!comparison) return null;
  const { counts } = comparison;
  const said = [
    ["worse", "verdict worse", "verdicts worse"],
    ["better", "verdict better", "verdicts better"],
    ["fewer-digits", "with fewer digits"],
    ["more-digits", "with more digits"],
    ["slower", "slower"],
    ["faster", "faster"],
    ["new", "new"],
    ["gone", "gone"],
  ]
    .filter(([name]) => counts[name] > 0)
    .map(([name, one, many]) => `${counts[name]} ${counts[name] === 1 || !many ? one : many}`);
  return h(
    "p",
    { class: "change-line" },
    "Against the earlier run: ",
    h("a", { href: hash_of("compare") }, said.join(", ") || "nothing changed beyond noise"),
    ".",
  );
}

// Cases that were recorded, one a family, the failing ones first.
function play_line(rows, index, most = 4) {
  const recorded = rows.filter(({ frames }) => frames && index.assets.includes(`frames/${frames}`));
  const first = [...recorded].sort((a, b) => rank(a.verdict) - rank(b.verdict));
  const names = [...group_by(first, (row) => row.family).values()].map(([row]) => row.case);
  if (names.length === 0) return null;
  const all = new Set(first.map((row) => row.case)).size;
  const links = names.slice(0, most).map((name) => [h("a", { href: case_hash(name) }, name), " "]);
  const more =
    all > Math.min(names.length, most) &&
    h("a", { href: hash_of("cases", "", { q: "recorded" }) }, `all ${all}`);
  return h(
    "p",
    { class: "play-line" },
    h("span", { "aria-hidden": "true" }, "▶ "),
    "Recorded in 3-D: ",
    links,
    more,
  );
}

// Where and with what: of the first run, and how many more there are.
function provenance(runs) {
  const shown = runs.filter(({ role }) => role === "shown");
  const [run] = shown;
  const more =
    shown.length > 1 ? `and ${shown.length - 1} more run${shown.length > 2 ? "s" : ""}` : "";
  return [
    run.date.replace("T", " ").replace("Z", " UTC"),
    `revision ${run.revision}`,
    run.toolchain,
    run.machine,
    more,
  ]
    .filter(Boolean)
    .join(" · ");
}

const to_case = (datum) =>
  typeof datum.case === "string" && datum.case !== "" && (location.hash = case_hash(datum.case));

// Why something falls short, most frequent cause first.
const causes_part = ({ causes }) =>
  causes.length > 0 &&
  h(
    "section",
    { class: "causes", "aria-labelledby": "causes-title" },
    h("h2", { id: "causes-title" }, "Why some fall short"),
    h(
      "ul",
      {},
      causes.map(({ because, records, configurations, case: name }) =>
        h(
          "li",
          {},
          h("strong", {}, `${plural(records, "record")}: `),
          `${because} (`,
          configurations.map((one, i) => [i > 0 && ", ", style_mark(one, 9), ` ${one}`]),
          "), most in ",
          h("a", { href: case_hash(name) }, name),
        ),
      ),
    ),
  );

// Who holds what, beside what it costs and how it comes to rest.
const overview_part = ({ summary }) =>
  summary &&
  h(
    "div",
    { class: "overview" },
    h(
      "section",
      { class: "overview-table", "aria-labelledby": "matrix-title" },
      h("h2", { id: "matrix-title" }, "Who holds, who creeps"),
      matrix(summary),
      causes_part(summary),
    ),
    h(
      "div",
      { class: "overview-plots" },
      summary.work && plot_figure(summary.work, { heading: "h2", on_click: to_case }),
      summary.slip &&
        plot_figure(summary.slip, {
          heading: "h2",
          on_click: () => (location.hash = case_hash(summary.slip.case)),
        }),
    ),
  );

// Diagrams of a sweep; they come when their part of the page has been read.
function sweep_part(index) {
  const is_diagram = ({ kind }) => kind === "phase-diagram";
  const families = index.families.filter(({ plots }) => plots.some(is_diagram));
  if (families.length === 0) return null;
  const place = h("div", { class: "plot-pairs" });
  for (const { name } of families)
    plots_of_family(name, index, { maps: false }).then((plots) =>
      place.append(...plots.filter(is_diagram).map((plot) => plot_figure(plot))),
    );
  return h(
    "section",
    { "aria-labelledby": "sweep-title" },
    h("h2", { id: "sweep-title" }, "Where it holds"),
    place,
  );
}

const stability_line = ({ stability }) =>
  stability &&
  h(
    "p",
    { class: "play-line stability-line" },
    h("a", { href: hash_of("stability") }, "Stability"),
    `: ${stability_sentences(stability).join("; ")}.`,
  );

const more_part = (shown, tally, index) => [
  stability_line(index),
  play_line(shown, index),
  Object.values(index.check_counts).some((count) => count > 0) && facts(tally, index),
];

const tally_line = (tally, cases) =>
  h(
    "p",
    { class: "subline" },
    `${plural(tally.records, "record")} of ${plural(cases, "case")}`,
    VERDICTS.filter((name) => tally[name] > 0).map((name) =>
      h(
        "a",
        {
          class: `tally verdict-${name}`,
          "data-term": name,
          href: hash_of("cases", "", { verdict: name }),
        },
        glyph(name, 13),
        ` ${counted(name, tally[name], format_count(tally[name]))}`,
      ),
    ),
    " ",
    h("a", { class: "words", href: hash_of("about", "words") }, "what these words mean"),
  );

export function summary_view({ index, rows, comparison }) {
  const shown = rows.filter((row) => index.runs[row.run].role === "shown");
  const current = shown.filter((row) => !row.of_engines);
  const only_engines = index.engines !== null && current.length === 0;
  const tally = tally_of(only_engines ? shown : current);
  const [verdict, sentence] = only_engines
    ? ["for-information", engines_headline(index.engines)]
    : index.compared && tally.bad === 0
      ? ["for-information", compared_headline(index.compared)]
      : headline(tally, index);
  const cases = new Set(current.map((row) => row.case)).size;
  return h(
    "section",
    { class: "view view-summary", "aria-labelledby": "summary-title" },
    h(
      "div",
      { class: "headline" },
      glyph(verdict, 44),
      h(
        "div",
        {},
        h("h1", { id: "summary-title", class: `verdict-${verdict}` }, sentence),
        !only_engines && tally_line(tally, cases),
        index.engines && engines_subline(index.engines),
        h("p", { class: "provenance" }, provenance(index.runs)),
        (only_engines || index.compared) && play_line(shown, index),
        change_line(comparison),
        machines_note(shown.map((row) => row.machine)),
      ),
    ),
    only_engines
      ? null
      : index.compared
        ? [failures_list(current), compared_parts(index, current)]
        : [
            sweep_part(index),
            failures_list(current),
            overview_part(index),
            more_part(shown, tally, index),
          ],
    index.engines && engines_parts(index.engines, index.runs),
  );
}
