// SPDX-License-Identifier: GPL-3.0-or-later
// The findings of a comparison as lists, with the cases that they name as links.
import { by_topic, parted } from "../../model/finding.js";
import { h } from "../dom.js";
import { case_hash } from "../route.js";

const LONG = 420; // letters
const SHORT = 260;

// Of a long text the beginning, up to a comma or a full stop; the rest is behind a fold.
function folded(text) {
  if (text.length <= LONG) return text;
  const end = Math.max(text.lastIndexOf(", ", SHORT), text.lastIndexOf(". ", SHORT));
  const cut = end > 0 ? end + 1 : SHORT;
  return [
    text.slice(0, cut),
    h("details", { class: "rest" }, h("summary", {}, "… the rest"), text.slice(cut)),
  ];
}

/** A list's entry, the lead in bold; a case's name at its start, without `folder`, leads there. */
export function sentence(note, cases, folder = "") {
  const [lead, rest] = parted(note);
  const name = cases.find((one) => lead === `${one}:` || lead.startsWith(`${one},`));
  const bold = name
    ? [h("a", { href: case_hash(folder + name) }, name), lead.slice(name.length)]
    : lead;
  return h("li", {}, lead && h("strong", {}, bold), folded(rest));
}

const MOST_OPEN = 3; // findings that are not folded

const plain_list = (notes, cases) =>
  h(
    "ul",
    {},
    notes.map((note) => sentence(note, cases)),
  );

const list = (notes, cases) =>
  notes.length <= MOST_OPEN + 1
    ? plain_list(notes, cases)
    : [
        plain_list(notes.slice(0, MOST_OPEN), cases),
        h(
          "details",
          {},
          h("summary", {}, `${notes.length - MOST_OPEN} more findings`),
          plain_list(notes.slice(MOST_OPEN), cases),
        ),
      ];

const box = (id, title, ...parts) =>
  h("section", { class: "findings", "aria-labelledby": id }, h("h2", { id }, title), ...parts);

/**
 * `findings`: [{run, notes}]. {chief, others}: what they say of all, and of single cases; null where
 * there is nothing.
 */
export function findings_parts(findings, rows, runs) {
  const cases = [...new Set(rows.map((row) => row.case))];
  const told = findings.map(({ run, notes }) => ({
    run: findings.length > 1 && h("h3", {}, runs[run].short),
    topics: by_topic(notes),
  }));
  const of = (is_wanted, write) =>
    told.flatMap(({ run, topics }) => {
      const wanted = topics.filter(([topic]) => is_wanted(topic));
      return wanted.length > 0 ? [run && run.cloneNode(true), wanted.map(write)] : [];
    });
  const chief = of(
    (topic) => topic === "",
    ([, notes]) => list(notes, cases),
  );
  const others = of(
    (topic) => topic !== "",
    ([topic, notes]) => h("section", {}, h("h3", {}, `${topic}/…`), list(notes, cases)),
  );
  return {
    chief: chief.length > 0 ? box("findings-title", "Findings", chief) : null,
    others:
      others.length > 0
        ? box(
            "findings-cases-title",
            "Findings, case by case",
            h("div", { class: "findings-topics" }, others),
          )
        : null,
  };
}
