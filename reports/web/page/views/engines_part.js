// SPDX-License-Identifier: GPL-3.0-or-later
// The summary of engines side by side: findings, engine × question, other builds beside their engine, the
// cheapest ways.
import { parted } from "../../model/finding.js";
import { format_count } from "../../model/number.js";
import { builds_tables } from "./builds_tables.js";
import { cheapest_table } from "./cheapest_table.js";
import { h } from "../dom.js";
import { engine_matrix } from "./engine_matrix.js";
import { sentence } from "./findings.js";
import { hash_of } from "../route.js";

const FOLDER = "engines/";
const OPEN = 8; // findings on single questions that stand open

const plural = (count, word) => `${format_count(count)} ${word}${count === 1 ? "" : "s"}`;

export function engines_headline({ rows, questions }) {
  const engines = new Set(rows.map(({ engine }) => engine)).size;
  const named = rows.length > engines ? ` in ${plural(rows.length, "configuration")}` : "";
  return `${plural(engines, "engine")}${named} side by side, ${plural(questions.length, "question")}.`;
}

// An engine that misses a tolerance is a result, not a failure of this run: said in plain ink.
const JUDGED = {
  pass: "meet it",
  fail: "miss it",
  error: "broke off",
  "expected-shortfall": "fall short as known",
  refuted: "refute a claim",
};

export function engines_subline({ judged }) {
  const { counts, ours, ours_met } = judged;
  const links = Object.keys(JUDGED)
    .filter((verdict) => counts[verdict] > 0)
    .map((verdict, i) => {
      const words = `${format_count(counts[verdict])} ${JUDGED[verdict]}`;
      return [i > 0 && ", ", h("a", { href: hash_of("cases", "", { verdict }) }, words)];
    });
  if (links.length === 0) return null;
  return h(
    "p",
    { class: "subline" },
    "Each answer against the tolerance of its case: ",
    links,
    ours > 0 && `; of ours ${ours_met} of ${ours} meet it`,
    ".",
  );
}

function findings_list(notes, questions) {
  const ids = questions.map(({ id }) => id);
  const is_about_one = (note) => ids.includes(parted(note)[0].slice(0, -1));
  const list = (some) =>
    h(
      "ul",
      {},
      some.map((note) => sentence(note, ids, FOLDER)),
    );
  const single = notes.filter(is_about_one);
  const rest = single.slice(OPEN);
  return [
    list(single.slice(0, OPEN)),
    rest.length > 0 &&
      h(
        "details",
        { class: "more-findings" },
        h("summary", {}, `${plural(rest.length, "more finding")} on single questions`),
        list(rest),
      ),
    list(notes.filter((note) => !is_about_one(note))),
  ];
}

function findings_box({ findings, questions }, runs) {
  const told = findings.filter(({ notes }) => notes.length > 0);
  if (told.length === 0) return null;
  return h(
    "section",
    { class: "findings", "aria-labelledby": "engine-findings-title" },
    h("h2", { id: "engine-findings-title" }, "Findings"),
    told.map(({ run, notes }) => [
      told.length > 1 && h("h3", {}, runs[run].short),
      findings_list(notes, questions),
    ]),
  );
}

export const engines_parts = (engines, runs) => [
  findings_box(engines, runs),
  h("h2", {}, "How far each engine is off"),
  engine_matrix(engines),
  builds_tables(engines),
  cheapest_table(engines),
];
