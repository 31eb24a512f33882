// SPDX-License-Identifier: GPL-3.0-or-later
// Who wins in each scene of a comparison, question by question: the least of a figure, with the runner-up.
import { chief_quantity, failure_of, figure_of, WORK } from "../model/figure.js";
import { machine_names } from "../model/machine.js";
import { group_by } from "../model/family.js";

// What is asked, by the figure that answers it; less is better in each.
const QUESTIONS = [
  ["final creep", "Creeps least"],
  ["steps to 1e-9", "At rest soonest (1e-9 m/s)"],
  [WORK, "Cheapest"],
];

// Of these less is not better: they tell where, among how many, or how much there was at first.
const NO_AMOUNT = /^(best|contacts|diagonal dominance|slip at first|memory|predicted)\b/;

function answer(group, { quantity, unit }) {
  // Of CPU times who wins may only have the faster machine.
  const named =
    quantity === WORK ? machine_names(group.map(({ record }) => record)) : (name) => name;
  const held = group
    .filter(({ record }) => failure_of(record) === "")
    .map(({ record, variant }) => ({
      label: named([variant.name, variant.contacts].filter(Boolean).join(" · "), record),
      value: figure_of(record, quantity),
    }))
    .filter(({ value }) => !Number.isNaN(value))
    .sort((a, b) => a.value - b.value);
  const reached = held.filter(({ value }) => Number.isFinite(value));
  if (reached.length === 0) return { quantity, unit, winner: null, asked: held.length };
  const ties = reached.filter(({ value }) => value === reached[0].value).length;
  return {
    quantity,
    unit,
    winner: reached[0],
    ties: ties - 1,
    second: reached[ties] ?? null,
    asked: held.length,
  };
}

/**
 * {questions: [{quantity, words, wins: [{label, count}], scenes}], scenes: [{case, title, answers}]} of
 * `entries`, [{record, variant}]; `answers` has a place for each question, null where it was not asked.
 */
export function winners_of(entries) {
  const scenes = [...group_by(entries, ({ record }) => record.case)].map(([name, group]) => {
    const figures = group.flatMap(({ record }) => record.figures);
    return { case: name, title: group[0].record.title, group, figures };
  });
  const known = QUESTIONS.filter(([wanted]) =>
    scenes.some(({ figures }) => figures.some(({ quantity }) => quantity === wanted)),
  );
  const asked_of = ({ figures }) =>
    known.map(([wanted]) => figures.find(({ quantity }) => quantity === wanted) ?? null);
  const told = scenes.map((scene) => {
    const asked = asked_of(scene);
    const answers = asked.map((figure) => (figure ? answer(scene.group, figure) : null));
    return { ...scene, answers };
  });
  const rest = told.filter(({ answers }) => answers.every((one) => one === null));
  const chief = rest.map((scene) => {
    const figure = chief_quantity(scene.group.map(({ record }) => record));
    return figure && !NO_AMOUNT.test(figure.quantity) ? answer(scene.group, figure) : null;
  });
  const thin = ({ case: name, title, answers }) => ({ case: name, title, answers });
  const with_answers = told.filter((scene) => !rest.includes(scene));
  return {
    questions: known.map(([quantity, words], i) => ({
      quantity,
      words,
      ...wins_of(with_answers.map(({ answers }) => answers[i])),
    })),
    scenes: with_answers.map(thin),
    others: rest
      .map((scene, i) => ({ ...thin(scene), answers: [chief[i]] }))
      .filter(({ answers }) => answers[0]?.winner),
  };
}

// Who wins most scenes of a question; who ties with others does not count as a winner alone.
function wins_of(answers) {
  const decided = answers.filter((one) => one?.winner);
  const wins = [...group_by(decided, ({ winner }) => winner.label)]
    .map(([label, list]) => ({ label, count: list.length }))
    .sort((a, b) => b.count - a.count);
  return { wins, scenes: decided.length };
}
