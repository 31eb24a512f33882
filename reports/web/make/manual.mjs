// SPDX-License-Identifier: GPL-3.0-or-later
// The verification manual of some runs: one static HTML text, a page a case, for A4 and for a screen.
import { decode_frames } from "../model/frames.js";
import { configuration_of, ordered_configurations } from "../model/configuration.js";
import { is_of_engines, record_labels } from "../model/engine.js";
import { family_name, group_by } from "../model/family.js";
import { is_comparison } from "../model/figure.js";
import { is_findings } from "../model/finding.js";
import { glossary_entry } from "../model/glossary.js";
import { format_count } from "../model/number.js";
import { problem_of } from "../model/problem.js";
import { case_command } from "../model/rerun.js";
import { surfaces_of } from "../model/surfaces.js";
import { counted, rank, VERDICTS, VERDICT_WORDS } from "../model/verdict.js";
import { know_configurations } from "../plots/configuration_style.js";
import { svg_of, svg_width } from "../plots/draw.js";
import { case_plots, family_plots } from "../plots/plots.js";
import { e } from "../sketch/tree.js";
import { document_html } from "./document.mjs";
import {
  claims_and_results,
  configuration_mark,
  entry_name,
  facts,
  problem_part,
  row,
  table,
  verdict_mark,
} from "./manual_parts.mjs";
import { pages_of, parameters_of } from "./manual_pages.mjs";

const MOST_NOTES = 12;

const worst_of = (entries) =>
  entries.map(({ record }) => record.verdict).reduce((a, b) => (rank(b) < rank(a) ? b : a));

function counts_text(entries) {
  const counts = group_by(entries, ({ record }) => record.verdict);
  return VERDICTS.filter((verdict) => counts.has(verdict))
    .map((verdict) =>
      counted(verdict, counts.get(verdict).length, format_count(counts.get(verdict).length)),
    )
    .join(", ");
}

function title_page(title, entries, heads) {
  const cases = new Set(entries.map(({ record }) => record.case)).size;
  return e(
    "section",
    { id: "title" },
    e("h1", {}, title),
    e(
      "p",
      {},
      "Cases with known answers for frictional contact: what is claimed, what was measured.",
    ),
    facts([
      [
        "Records",
        `${format_count(entries.length)} of ${format_count(cases)} cases: ${counts_text(entries)}`,
      ],
      ...heads.flatMap((head) => [
        ["Run", head.name],
        ["Revision", head.revision],
        ["Date", head.date.replace("T", " ").replace("Z", " UTC")],
        ["Toolchain", head.toolchain],
        ["Machine", head.machine],
      ]),
    ]),
  );
}

const id_of = (place) => `case-${place + 1}`;

function contents(pages) {
  const families = group_by(
    pages.map((page, place) => ({ page, place })),
    ({ page }) => family_name(page.cases[0]).split("/")[0],
  );
  return e(
    "section",
    { class: "leaf", id: "contents" },
    e("h2", {}, "Contents"),
    e(
      "ol",
      { class: "contents" },
      e("li", {}, e("a", { href: "#reading" }, "How to read this manual")),
      [...families].map(([family, list]) =>
        e(
          "li",
          {},
          family,
          e(
            "ol",
            {},
            list.map(({ page, place }) =>
              e(
                "li",
                {},
                e("a", { href: `#${id_of(place)}` }, `${place + 1}  ${page.name}`),
                page.cases.length > 1 && ` (${page.cases.length} cases)`,
                " ",
                verdict_mark(worst_of(page.entries)),
              ),
            ),
          ),
        ),
      ),
    ),
  );
}

const meaning_of = (word) => glossary_entry(word)?.meaning ?? "";

function reading(entries) {
  const verdicts = VERDICTS.filter((verdict) =>
    entries.some(
      ({ record }) =>
        record.checks.some((check) => check.verdict === verdict) || record.verdict === verdict,
    ),
  );
  const configurations = ordered_configurations(
    entries.map(({ record }) => configuration_of(record)),
  );
  return e(
    "section",
    { class: "leaf", id: "reading" },
    e("h2", {}, "How to read this manual"),
    e(
      "p",
      {},
      "Each case has a page: the problem with its drawing and its data, what is claimed of it with formula, source and tolerance, what was measured, and the command that runs it again. Drawings are made of the problem’s geometry, seen from the side at the start; where a case ran many simulations, they show the first. Every number comes from the records of the runs named on the title page.",
    ),
    e(
      "p",
      {},
      "A check holds when |error| ÷ tolerance is at most 100 %. Errors and tolerances marked ‘rel’ are relative to the size of the quantity. The state hash is a number made of every bit of the last state: equal hashes mean that two runs did exactly the same.",
    ),
    e("h3", {}, "Verdicts"),
    facts(
      verdicts.map((verdict) => [verdict_mark(verdict), meaning_of(VERDICT_WORDS[verdict])]),
      "words",
    ),
    e("h3", {}, "Configurations"),
    facts(
      configurations.map((name) => [
        e("span", {}, configuration_mark(name)),
        meaning_of(name) || "A configuration of the engine’s own.",
      ]),
      "words",
    ),
  );
}

function notes_part(entries, labels) {
  const notes = new Map();
  entries.forEach(({ record }, i) => {
    const all = record.error ? [`broke off: ${record.error}`, ...record.notes] : record.notes;
    for (const note of all) notes.set(note, [...(notes.get(note) ?? []), labels[i]]);
  });
  const list = [...notes];
  if (list.length === 0) return null;
  return [
    e("h3", {}, "Notes"),
    e(
      "ul",
      { class: "notes" },
      list
        .slice(0, MOST_NOTES)
        .map(([note, who]) =>
          e(
            "li",
            {},
            who.length < entries.length &&
              who.some(Boolean) &&
              `${[...new Set(who)].filter(Boolean).join(", ")}: `,
            note,
          ),
        ),
      list.length > MOST_NOTES &&
        e("li", {}, `and ${list.length - MOST_NOTES} more, in the records.`),
    ),
  ];
}

const HASH_COLUMNS = [["Configuration"], ["State hash"]];

function rerun_part(page, names) {
  const { record } = page.entries[0];
  const hashes = page.entries
    .map((entry, i) => [names[i], entry.record.state_hash])
    .filter(([, hash]) => hash);
  const command =
    page.cases.length > 1
      ? case_command(record).replace(/--case .*$/, `--case '${page.name.replace(/'/g, "?")}'`)
      : case_command(record);
  return [
    e("h3", {}, "Run it again"),
    e("p", {}, e("code", {}, command)),
    hashes.length > 0 &&
      table(
        HASH_COLUMNS,
        hashes.map(([name, hash]) => row([name, e("code", {}, hash)], HASH_COLUMNS)),
      ),
  ];
}

// One picture says most: the case's first series, of cases together that over their parameters.
async function plot_part(page, heads) {
  const [plot] =
    page.cases.length > 1
      ? family_plots(family_name(page.cases[0]), page.entries, heads)
      : case_plots(page.name, page.entries, heads).filter(({ kind }) => kind !== "phases");
  if (!plot) return null;
  const svg = await svg_of(plot.spec, "light", Math.min(700, svg_width(plot)));
  return e(
    "figure",
    { class: "plot" },
    e("img", {
      src: `data:image/svg+xml;base64,${Buffer.from(svg).toString("base64")}`,
      alt: plot.description ?? plot.title,
    }),
    e("figcaption", {}, [plot.title, plot.caption].filter(Boolean).join(". ")),
  );
}

// The meshes as the first readable recording of the page has them.
function surfaces_from(entries, bytes_of) {
  for (const { record } of entries) {
    const bytes = record.frames ? bytes_of(record.frames) : null;
    if (!bytes) continue;
    const recording = decode_frames(
      bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength),
    );
    return (problem) => surfaces_of(problem, recording);
  }
  return () => new Map();
}

async function case_page(page, place, { heads, bytes_of }) {
  const records = page.entries.map(({ record }) => record);
  const several = new Set(page.entries.map(({ run }) => run)).size > 1;
  const labels = record_labels(
    records,
    (i) => (several ? heads[page.entries[i].run].short : ""),
    (i) => records[i].case,
  );
  const together = page.cases.length > 1;
  const case_labels = records.map((record) =>
    together ? parameters_of(record.case, page.name) : "",
  );
  const names = records.map((record, i) => entry_name(record, labels[i], case_labels[i]));
  const told = records.find((record) => problem_of(record)) ?? records[0];
  return e(
    "section",
    { class: "leaf", id: id_of(place) },
    e("h2", {}, `${place + 1}  ${page.name}`),
    e(
      "p",
      {},
      verdict_mark(worst_of(page.entries)),
      " ",
      together ? `${page.cases.length} cases: ${counts_text(page.entries)}` : told.title,
    ),
    together &&
      e(
        "p",
        { class: "of" },
        `The problem and the drawing are those of ${told.case}: ${told.title}.`,
      ),
    // As long as the one that was followed longest: others may have broken.
    problem_part(
      { ...told, series: page.entries.flatMap(({ record }) => record.series) },
      surfaces_from(page.entries, bytes_of),
    ),
    claims_and_results(records.map((record, i) => ({ record, name: names[i] }))),
    await plot_part(page, heads),
    notes_part(
      page.entries,
      labels.map((label, i) => [case_labels[i], label].filter(Boolean).join(" · ")),
    ),
    rerun_part(page, names),
  );
}

/** The manual's HTML. `bytes_of(name)` gives a recording; `style` is the style sheet. */
export async function manual_html({ runs, heads, title, style, bytes_of }) {
  const entries = runs
    .flatMap(({ records }, run) => records.map((record) => ({ record, run })))
    .filter(
      ({ record }) => !is_findings(record) && !is_of_engines(record) && !is_comparison([record]),
    );
  if (entries.length === 0)
    throw new Error("these runs hold no record of ./stiction validate, of which a manual is made");
  know_configurations([...new Set(entries.map(({ record }) => configuration_of(record)))]);
  const pages = pages_of(entries);
  const body = [title_page(title, entries, heads), contents(pages), reading(entries)];
  for (const [place, page] of pages.entries())
    body.push(await case_page(page, place, { heads, bytes_of }));
  return document_html(title, style, body);
}
