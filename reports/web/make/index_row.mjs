// SPDX-License-Identifier: GPL-3.0-or-later
import { margin } from "../model/check_text.js";
import { configuration_of } from "../model/configuration.js";
import { fingerprint_of } from "../model/machine.js";
import { to_number } from "../model/number.js";
import { fewest_digits, worst_check } from "../model/verdict.js";
import { variant_key } from "../model/variant.js";

/** Texts that many records share, once. */
export class Texts {
  list = [];
  #places = new Map();
  add(text) {
    let place = this.#places.get(text);
    if (place === undefined) {
      place = this.list.push(text) - 1;
      this.#places.set(text, place);
    }
    return place;
  }
}

export const short_number = (value) =>
  Number.isFinite(value)
    ? Number(value.toPrecision(7))
    : String(value).replace("Infinity", "inf").toLowerCase();

// All that a record's checks, figures and series are about, each once, for the search.
const quantities_of = ({ checks, figures, series }) =>
  [
    ...new Set([
      ...checks.map(({ quantity }) => quantity),
      ...figures.map(({ quantity }) => quantity),
      ...series.map(({ name }) => name),
    ]),
  ].join("\n");

/** One record in the index. page/rows.js reads it in the same order. */
export function row_of(texts, { record, run, part, label }) {
  const check = worst_check(record.checks, margin);
  const text = (value) => texts.add(value);
  const number = (value) => short_number(to_number(value));
  const optional = (value) => (value === null ? null : number(value));
  return [
    run,
    part,
    text(record.case),
    text(record.title),
    text(record.engine),
    text(variant_key(record)),
    text(record.verdict),
    number(record.cost.cpu_seconds),
    record.cost.steps,
    record.cost.contact_updates,
    number(record.cost.ns_per_contact_update),
    record.checks.length,
    text(record.frames ?? ""),
    text(record.verdict === "error" ? record.error : ""),
    optional(fewest_digits(record)),
    check
      ? [
          text(check.quantity),
          text(check.unit),
          number(check.value),
          number(check.expected),
          number(check.error),
          check.relative ? 1 : 0,
          number(check.tolerance),
          number(check.of_tolerance),
          check.digits === undefined ? null : number(check.digits),
          text(check.verdict),
          check.band ? check.band.map(number) : null,
        ]
      : 0,
    label ? text(label) : 0,
    text(configuration_of(record)),
    text(quantities_of(record)),
    text(fingerprint_of(record)),
  ];
}
