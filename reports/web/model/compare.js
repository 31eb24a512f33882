// SPDX-License-Identifier: GPL-3.0-or-later
// Two runs side by side: what changed in verdicts, digits and cost beyond noise.
import { is_decided, rank } from "./verdict.js";
import { to_number } from "./number.js";
import { group_by } from "./family.js";
import { natural_sort } from "./natural.js";
import { fingerprint_of } from "./machine.js";
import { variant_key } from "./variant.js";

/** A change of fewer digits than this is noise. */
export const DIGITS_NOISE = 0.3;

/** Errors below this share of their tolerance on both sides decide nothing, whatever their digits. */
export const NEGLIGIBLE_SHARE = 0.01;

/** CPU times are compared from this on, s: below it the clock and the machine's other work tell more. */
export const LEAST_SECONDS = 0.05;

/** CPU times that differ by less than this factor are noise, even where pairs spread less. */
export const LEAST_COST_NOISE = 1.15;

const NORMAL_SPREAD = 1.4826; // standard deviation ÷ median absolute deviation, of a normal law
const DEVIATIONS = 3;
const FEWEST_PAIRS = 8; // to tell a spread

const decided = (check) => is_decided(check.verdict);
const share = (check) => to_number(check.of_tolerance);

// Digits of a check; where zero is expected of a quantity without a scale, how many powers of ten its
// error is below its tolerance.
const precision = (check) =>
  check.digits === undefined
    ? Math.max(-Infinity, Math.min(-Math.log10(NEGLIGIBLE_SHARE), -Math.log10(share(check))))
    : to_number(check.digits);

// The check whose digits changed most, of those that are not negligible twice: {change, quantity}.
function digits_change(before, after) {
  const earlier = new Map(before.checks.filter(decided).map((check) => [check.quantity, check]));
  let most = { change: 0, quantity: "" };
  for (const check of after.checks.filter(decided)) {
    const old = earlier.get(check.quantity);
    if (!old || Math.max(share(check), share(old)) < NEGLIGIBLE_SHARE) continue;
    const change = precision(check) - precision(old);
    if (Math.abs(change) > Math.abs(most.change)) most = { change, quantity: check.quantity };
  }
  return most;
}

function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/**
 * How CPU times of the same work differ: {median, factor, pairs}. A ratio within `factor` of the median is
 * noise: three deviations of all pairs, and never less than LEAST_COST_NOISE. A median near 1 counts as 1.
 */
export function cost_noise(ratios) {
  if (ratios.length < FEWEST_PAIRS)
    return { median: 1, factor: LEAST_COST_NOISE, pairs: ratios.length };
  const logs = ratios.map(Math.log);
  const middle = median(logs);
  const spread = NORMAL_SPREAD * median(logs.map((log) => Math.abs(log - middle)));
  const centre = Math.exp(middle);
  return {
    median: Math.max(centre, 1 / centre) < LEAST_COST_NOISE ? 1 : centre,
    factor: Math.max(LEAST_COST_NOISE, Math.exp(DEVIATIONS * spread)),
    pairs: ratios.length,
  };
}

function class_of({ before, after, digits_change: digits, cost_ratio, timed }, noise) {
  if (!before) return "new";
  if (!after) return "gone";
  const verdicts = rank(after.verdict) - rank(before.verdict);
  if (verdicts !== 0) return verdicts < 0 ? "worse" : "better";
  if (Math.abs(digits) >= DIGITS_NOISE) return digits < 0 ? "fewer-digits" : "more-digits";
  if (!timed) return "same";
  const ratio = cost_ratio / noise.median;
  if (ratio > noise.factor) return "slower";
  return ratio < 1 / noise.factor ? "faster" : "same";
}

/** Worst first. */
export const CHANGE_CLASSES = [
  "worse",
  "gone",
  "fewer-digits",
  "slower",
  "better",
  "more-digits",
  "faster",
  "new",
  "same",
];

export const CHANGE_WORDS = {
  worse: "verdict worse",
  gone: "gone",
  "fewer-digits": "fewer digits",
  slower: "slower",
  better: "verdict better",
  "more-digits": "more digits",
  faster: "faster",
  new: "new",
  same: "unchanged",
};

/** Why a pair counts as unchanged: [reason, words]. */
export const SAME_WORDS = {
  "end-state": "the same end state, bit by bit",
  digits: `digits changed by less than ${DIGITS_NOISE}, or the error was below ${NEGLIGIBLE_SHARE * 100} % of its tolerance both times`,
};

// CPU time says something where both runs took long enough.
const is_timed = (before, after) =>
  [before, after].every((record) => to_number(record.cost.cpu_seconds) >= LEAST_SECONDS);

// Whether the two of a pair ran on different machines, whose timings don't compare.
const is_across = ({ before, after }) =>
  Boolean(before && after) && fingerprint_of(before) !== fingerprint_of(after);

const machines_key = ({ before, after }) =>
  before && after ? `${fingerprint_of(before)}\n${fingerprint_of(after)}` : "";

/**
 * Pairs records by case, engine and settings. Gives [{case, class, before, after, digits_change,
 * quantity, cost_ratio, timed, across, hash_equal}], worst first; `before` and `after` are records or null. `across`:
 * on different machines; then CPU times count only beside those of enough other pairs of the same two.
 */
export function compare(before_records, after_records) {
  const key = (record) => `${record.case}\n${variant_key(record)}`;
  const before = group_by(before_records, key);
  const after = group_by(after_records, key);
  const names = natural_sort([...new Set([...after.keys(), ...before.keys()])], (name) =>
    name.slice(0, name.indexOf("\n")),
  );
  const pairs = names.map((name) => {
    const [old_one, new_one] = [before.get(name)?.at(-1) ?? null, after.get(name)?.at(-1) ?? null];
    const paired = old_one && new_one;
    const digits = paired ? digits_change(old_one, new_one) : { change: 0, quantity: "" };
    const ratio = paired
      ? to_number(new_one.cost.cpu_seconds) / to_number(old_one.cost.cpu_seconds)
      : NaN;
    return {
      case: (new_one ?? old_one).case,
      before: old_one,
      after: new_one,
      digits_change: digits.change,
      quantity: digits.quantity,
      cost_ratio: Number.isFinite(ratio) ? ratio : null,
      timed: Boolean(paired) && Number.isFinite(ratio) && is_timed(old_one, new_one),
      hash_equal:
        paired && old_one.state_hash !== "" ? old_one.state_hash === new_one.state_hash : null,
    };
  });
  const noises = new Map(
    [...group_by(pairs, machines_key)].map(([machines, group]) => [machines, noise_of(group)]),
  );
  const changes = pairs.map((pair) => {
    const across = is_across(pair);
    const noise = noises.get(machines_key(pair));
    const timed = pair.timed && (!across || noise.pairs >= FEWEST_PAIRS);
    const judged = { ...pair, across, timed };
    return { class: class_of(judged, noise), ...judged };
  });
  return changes.sort((a, b) => CHANGE_CLASSES.indexOf(a.class) - CHANGE_CLASSES.indexOf(b.class));
}

/** The noise of each two machines on which pairs as compare() gives them ran: [{before, after, across, …noise}]. */
export const noises_of = (changes) =>
  [
    ...group_by(
      changes.filter(({ timed }) => timed),
      machines_key,
    ).values(),
  ].map((group) => ({
    before: group[0].before,
    after: group[0].after,
    across: group[0].across,
    ...noise_of(group),
  }));

/** The noise of the CPU times of pairs as compare() gives them. */
export const noise_of = (pairs) =>
  cost_noise(pairs.filter(({ timed }) => timed).map(({ cost_ratio }) => cost_ratio));

/** Why a pair of class "same" is: a key of SAME_WORDS. */
export const same_reason = ({ hash_equal }) => (hash_equal ? "end-state" : "digits");
