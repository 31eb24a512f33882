// SPDX-License-Identifier: GPL-3.0-or-later
// Another build of an engine beside it, such as single beside double precision: error and CPU time of the
// same answers, with the same efforts.
import { short_error } from "../../model/engine_answer.js";
import { general } from "../../model/number.js";
import { h } from "../dom.js";
import { hash_of } from "../route.js";

const WORDS = { broke: "broke", never: "never" };

const error_words = ({ kind, error }, unit) =>
  WORDS[kind] ?? (error === null ? "–" : short_error(error, unit).replace(/^\+/, ""));

const engine_of = (name) => name.split(" · ")[0];

const ms = ({ seconds }) =>
  seconds === null ? "–" : seconds < 1 ? general(1e3 * seconds, 3) : String(Math.round(1e3 * seconds));

const median = (values) => {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
};

function speed_words(answers) {
  const speeds = answers.map(({ speed }) => speed).filter((speed) => speed !== null);
  if (speeds.length === 0) return "";
  const [least, most] = [Math.min(...speeds), Math.max(...speeds)];
  return (
    `Speed: × ${median(speeds).toFixed(2)} in the median of ${speeds.length} answers, ` +
    `${least.toFixed(2)} to ${most.toFixed(2)}. `
  );
}

function answer_row(pair, question, first) {
  const { effort, own, build, speed } = pair;
  const number = (text, extra = "") => h("td", { class: `number ${extra}` }, text);
  return h(
    "tr",
    {},
    first,
    number(effort === 0 ? "usual" : String(effort)),
    number(error_words(own, question.unit)),
    number(error_words(build, question.unit)),
    number(ms(own)),
    number(ms(build)),
    number(speed === null ? "–" : `× ${speed.toFixed(2)}`, "ratio"),
  );
}

function build_table({ own, build, answers }, questions) {
  const of = new Map(questions.map((one) => [one.case, one]));
  const by_case = new Map();
  for (const pair of answers) by_case.set(pair.case, [...(by_case.get(pair.case) ?? []), pair]);
  const heading = (text, unit) =>
    h("th", { scope: "col", class: "number" }, text, unit && h("span", { class: "unit" }, ` ${unit}`));
  return [
    h("h3", {}, `${build} beside ${own}`),
    h(
      "p",
      {},
      speed_words(answers),
      "The same settings and steps; CPU time of one run each, one right behind the other.",
    ),
    h(
      "div",
      { class: "data-scroll", tabindex: "0", role: "region", "aria-label": `${build} beside ${own}` },
      h(
        "table",
        { class: "cheapest builds" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            h("th", { scope: "col" }, "Question"),
            heading("Effort"),
            heading("|error|", engine_of(own)),
            heading("|error|", engine_of(build)),
            heading("CPU ms", engine_of(own)),
            heading("CPU ms", engine_of(build)),
            heading("Speed"),
          ),
        ),
        [...by_case].map(([name, pairs]) => {
          const question = of.get(name);
          const first = h(
            "th",
            { scope: "rowgroup", rowspan: pairs.length },
            h("a", { href: hash_of("case", name), title: question.words }, question.id),
            question.unit && h("span", { class: "unit" }, ` ${question.unit}`),
          );
          return h(
            "tbody",
            {},
            pairs.map((pair, i) => answer_row(pair, question, i === 0 && first)),
          );
        }),
      ),
    ),
  ];
}

/** Null where no other build of an engine was asked. */
export function builds_tables({ builds, questions }) {
  if (builds.length === 0) return null;
  return h(
    "section",
    { "aria-labelledby": "builds-title" },
    h("h2", { id: "builds-title" }, "Other builds beside their engine"),
    builds.map((one) => build_table(one, questions)),
  );
}
