// SPDX-License-Identifier: GPL-3.0-or-later
// An engine beside another build of it, answer by answer, as build_pairs() in
// validation/comparison/engines/build_pairs.h: the same configuration, the same effort.
import { build_of } from "./engine.js";
import { answer_of, failed_efforts } from "./engine_answer.js";
import { figure_of, WORK } from "./figure.js";
import { fingerprint_of } from "./machine.js";
import { to_number } from "./number.js";

// {kind, error, seconds} of each effort with which it was asked, by its number.
function answers_of(record) {
  const { kind, error } = answer_of(record);
  const all = new Map([[0, { kind, error: Math.abs(error), seconds: figure_of(record, WORK) }]]);
  const failed = failed_efforts(record).map(({ effort }) => effort);
  for (const effort of failed) all.set(effort, { kind: "broke", error: NaN, seconds: NaN });
  const { x, y } = record.series[0] ?? { x: [], y: [] };
  let effort = -1;
  x.forEach((seconds, i) => {
    do ++effort;
    while (failed.includes(effort));
    const size = to_number(y[i]);
    if (effort > 0)
      all.set(effort, {
        kind: Number.isNaN(size) ? "never" : "told",
        error: size,
        seconds: to_number(seconds),
      });
  });
  return all;
}

const sendable = ({ kind, error, seconds }) => ({
  kind,
  error: Number.isFinite(error) ? error : null,
  seconds: Number.isFinite(seconds) ? seconds : null,
});

function pairs_of(own, build) {
  if (answer_of(own).kind === "lacks" || answer_of(build).kind === "lacks") return [];
  const same_machine = fingerprint_of(own) === fingerprint_of(build);
  const [left, right] = [answers_of(own), answers_of(build)];
  return [...left.keys()]
    .filter((effort) => right.has(effort))
    .sort((a, b) => a - b)
    .map((effort) => {
      const pair = { own: sendable(left.get(effort)), build: sendable(right.get(effort)) };
      const both = same_machine && pair.own.seconds > 0 && pair.build.seconds > 0;
      const speed = both ? pair.own.seconds / pair.build.seconds : null;
      return { case: own.case, effort, ...pair, speed };
    });
}

/**
 * `told`: [{name, record}] of records engines/…. [{own, build, answers}] with the names of both rows, of each
 * row that is another build; `answers`: [{case, effort, own, build, speed}], where `speed` is the CPU time of the
 * engine over that of the build, null where they ran on different machines.
 */
export function builds_beside(told) {
  const same = (a, b) =>
    a.record.case === b.record.case &&
    a.record.settings.configuration === b.record.settings.configuration;
  const tables = new Map();
  for (const build of told.filter(({ record }) => build_of(record) !== "")) {
    const own = told.find(
      (one) => one.record.engine === build_of(build.record) && same(one, build),
    );
    if (!own) continue;
    const key = `${own.name}\n${build.name}`;
    if (!tables.has(key)) tables.set(key, { own: own.name, build: build.name, answers: [] });
    tables.get(key).answers.push(...pairs_of(own.record, build.record));
  }
  return [...tables.values()].filter(({ answers }) => answers.length > 0);
}
