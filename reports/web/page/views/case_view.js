// SPDX-License-Identifier: GPL-3.0-or-later
// One case: what it claims, what was measured, how it went, what it cost.
import { is_comparison } from "../../model/figure.js";
import { format_count, format_value, to_number } from "../../model/number.js";
import { compared_variants, is_answer, is_engine_case, record_labels } from "../../model/engine.js";
import { rank } from "../../model/verdict.js";
import { case_head } from "./case_head.js";
import { checks_height, checks_section } from "./checks_section.js";
import { comparison_part } from "./comparison_part.js";
import { cost_table } from "./cost_table.js";
import { engine_case_part } from "./engine_case_part.js";
import { h, replace } from "../dom.js";
import { decode_frames } from "../../model/frames.js";
import { surfaces_of } from "../../model/surfaces.js";
import { bytes_of } from "../asset.js";
import { telling_pair } from "../player/telling.js";
import { player_figure } from "../player/player_figure.js";
import { plot_figure } from "../widgets/plot_figure.js";
import { problem_height, problem_part } from "./problem_part.js";
import { plots_of_case, plots_of_family, records_of_case } from "../records.js";
import { rerun_part } from "./rerun_part.js";
import { results_part } from "./results_table.js";
import { hash_of } from "../route.js";

function notes_of(entries) {
  const by_note = new Map();
  for (const { record, label } of entries) {
    const all = record.error ? [`broke off: ${record.error}`, ...record.notes] : record.notes;
    for (const note of all) by_note.set(note, [...(by_note.get(note) ?? []), label]);
  }
  return [...by_note].map(([note, labels]) => [
    note,
    labels.length === entries.length ? "" : labels.filter(Boolean).join(", "),
  ]);
}

// Meshes of the bodies, each once.
function meshes_of(records) {
  const texts = records.flatMap(({ meshes }) =>
    meshes.map(
      (mesh) =>
        `Mesh of ${mesh.bodies}: ${format_count(mesh.vertices)} vertices, ${format_count(mesh.tetrahedra)} tetrahedra, ` +
        `dihedral angles ${format_angle(mesh.min_dihedral_angle)} to ${format_angle(mesh.max_dihedral_angle)}, ` +
        `shortest altitude ${format_value(Number(to_number(mesh.min_altitude).toPrecision(3)))} m.`,
    ),
  );
  return [...new Set(texts)].map((text) => h("p", { class: "provenance" }, text));
}

const format_angle = (value) => `${to_number(value).toFixed(1)}°`;

function environment_of(records, runs) {
  const told = records.map((record) => ({ ...record.environment, run: runs[record.run] }));
  const unique = [
    ...new Map(
      told.map((one) => [`${one.revision} ${one.toolchain} ${one.machine} ${one.run.name}`, one]),
    ).values(),
  ];
  return unique.map((one) =>
    h(
      "p",
      { class: "provenance" },
      [
        one.run.role === "against" ? "earlier run" : "",
        one.date.replace("T", " ").replace("Z", " UTC"),
        `revision ${one.revision}`,
        one.toolchain,
        one.machine,
      ]
        .filter(Boolean)
        .join(" · "),
    ),
  );
}

// Meshes are drawn as recorded; a recording that cannot be read has nothing to give.
async function recorded_surfaces(recorded) {
  if (recorded.length === 0) return undefined;
  try {
    const recording = decode_frames(await bytes_of(`frames/${recorded[0].record.frames}`));
    return (problem) => surfaces_of(problem, recording);
  } catch {
    return undefined;
  }
}

// How many plots stand beside the claims and notes: as many as these leave room for.
function plots_beside(entries, notes, with_player) {
  const height =
    problem_height(entries.map(({ record }) => record)) +
    checks_height(entries) +
    notes.reduce((sum, [note, who]) => sum + 23 * Math.ceil((note.length + who.length) / 78), 0);
  return Math.max(0, Math.round((height - (with_player ? 340 : 200)) / 340));
}

/**
 * Fills `element` with the case; `list` are the rows among which previous and next are meant, `of` is the
 * label of the variant and `check` the quantity of the check that was asked for.
 */
export async function show_case(
  element,
  name,
  { index, rows },
  list,
  { of: chosen = "", check = "" } = {},
) {
  const all = await records_of_case(name, rows);
  const shown = all.filter((record) => index.runs[record.run].role === "shown");
  const of_engines = is_engine_case(name);
  const compared = of_engines || is_comparison(all);
  // A comparison is told of the runs shown; the view that compares runs has the earlier ones.
  const records = compared && shown.length > 0 ? shown : all;
  if (records.length === 0) {
    replace(
      element,
      h("h1", {}, "There is no such case"),
      h(
        "p",
        {},
        "The page holds no case named ",
        h("code", {}, name),
        ". ",
        h("a", { href: hash_of("cases") }, "All cases"),
        ".",
      ),
    );
    return;
  }
  const several_runs = new Set(records.map((record) => record.run)).size > 1;
  const run_of = (i) => (several_runs ? index.runs[records[i].run].short : "");
  const variants = compared ? compared_variants(records, run_of) : [];
  const labels = compared
    ? variants.map(({ label }) => label)
    : record_labels(records, (i) => index.runs[records[i].run].short);
  const entries = records.map((record, i) => ({
    record,
    label: labels[i],
    run: run_of(i),
    variant: variants[i],
  }));
  const worst = (shown.length > 0 ? shown : records).reduce((a, b) =>
    rank(b.verdict) < rank(a.verdict) ? b : a,
  ).verdict;
  const family = rows.find((row) => row.case === name).family;
  const order =
    of_engines && index.engines
      ? index.engines.questions.map((question) => question.case)
      : [...new Set(list.map((row) => row.case))];
  const notes = notes_of(entries);
  const recorded = entries.filter(
    ({ record }) => record.frames && index.assets.includes(`frames/${record.frames}`),
  );
  const plots = of_engines
    ? await plots_of_family(family, index)
    : await plots_of_case(name, rows, index);
  const figures =
    plots === null
      ? [
          h(
            "p",
            { class: "message" },
            "The plots of this case were left out to keep the page small.",
          ),
        ]
      : plots.map((plot) => plot_figure(plot));
  const surfaces = compared ? undefined : await recorded_surfaces(recorded);
  const beside = plots_beside(entries, notes, recorded.length > 0);

  replace(
    element,
    case_head({ name, family, records, worst, compared, order, stability: index.stability }),
    of_engines && engine_case_part(entries, figures, new Set(rows.map((row) => row.case)), chosen),
    compared && !of_engines && comparison_part(entries, figures),
    !compared &&
      h(
        "div",
        {
          class: [
            "case-columns",
            recorded.length > 0 && "with-player",
            records.every(is_answer) && "of-engines",
          ]
            .filter(Boolean)
            .join(" "),
        },
        h(
          "div",
          { class: "case-claims" },
          problem_part(records, surfaces),
          h("h2", {}, "What must hold"),
          entries.some(({ record }) => record.checks.length > 0)
            ? checks_section(entries, check)
            : h("p", {}, "Nothing was checked."),
          notes.length > 0 &&
            h(
              "div",
              { class: "notes" },
              h("h2", {}, "Notes"),
              h(
                "ul",
                {},
                notes.map(([note, who]) => h("li", {}, who && h("strong", {}, `${who}: `), note)),
              ),
            ),
        ),
        h(
          "div",
          { class: "case-pictures" },
          recorded.length > 0 && player_figure(recorded, telling_pair(recorded, index.runs)),
          figures.slice(0, beside),
        ),
      ),
    !compared && [
      h("h2", {}, entries.length > 1 ? "Results by configuration" : "Results"),
      results_part(entries),
      !records.every(is_answer) && rerun_part(entries),
    ],
    !compared && figures.length > beside && h("div", { class: "plot-grid" }, figures.slice(beside)),
    h("h2", {}, "Cost"),
    (compared || records.every(is_answer)) && entries.length > 4
      ? h("details", {}, h("summary", {}, "Engine, settings and cost of each"), cost_table(entries))
      : cost_table(entries, { with_settings: compared }),
    meshes_of(records),
    environment_of(records, index.runs),
  );
  if (check)
    setTimeout(() => element.querySelector(".claim.chosen")?.scrollIntoView({ block: "center" }));
}
