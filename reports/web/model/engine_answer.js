// SPDX-License-Identifier: GPL-3.0-or-later
// What a record engines/… says: how far an answer is off, or why there is none.
import { is_command } from "./engine.js";
import { to_number } from "./number.js";

/**
 * What an engine answered: {kind, error, why}. "told": how far it is off; "never": it has no answer;
 * "broke"; "lacks": it cannot be asked. `why` says so in words.
 */
export function answer_of(record) {
  if (record.verdict === "not-applicable") {
    const notes = record.notes.filter((note) => !is_command(note));
    return { kind: "lacks", error: NaN, why: notes.join("; ") || "the engine lacks what it takes" };
  }
  const figure = record.figures.find(({ quantity }) => quantity === "error");
  if (!figure) {
    const reasons = record.failures.map(({ reason }) => reason).filter(Boolean);
    return { kind: "broke", error: NaN, why: record.error || reasons[0] || "it gave no answer" };
  }
  const error = to_number(figure.value);
  return Number.isNaN(error)
    ? { kind: "never", error, why: "there is none: it never came to what is asked for" }
    : { kind: "told", error, why: "" };
}

/** Efforts with which it failed: [{effort, reason}]. */
export const failed_efforts = (record) =>
  record.verdict === "not-applicable"
    ? []
    : record.failures
        .filter(({ parameter }) => parameter === "effort")
        .flatMap(({ reason, values }) =>
          values.map((value) => ({ effort: to_number(value), reason: reason || "no answer" })),
        );

/** "+3e-5", "4.2e-13", as short_error() in validation/comparison/engines/engine_matrix.cpp. */
export function short_error(error, unit) {
  if (Number.isNaN(error)) return "never";
  if (error === 0) return "0";
  if (!Number.isFinite(error)) return error > 0 ? "+∞" : "−∞";
  const size = Math.abs(error);
  // What is neither an angle nor dimensionless is a magnitude: it has no sign.
  if (!["°", "1", "relative", ""].includes(unit)) return error.toExponential(1);
  const sign = error > 0 ? "+" : "-";
  if (size < 1e-3) return sign + size.toExponential(0);
  const [digits, exponent] = size.toExponential(1).split("e");
  const text =
    Number(exponent) >= 2 ? `${digits}e${exponent}` : String(Number(size.toPrecision(2)));
  return sign + text.replace(".0e", "e");
}
