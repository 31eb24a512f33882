// SPDX-License-Identifier: GPL-3.0-or-later
// What a set of rows comes to.
import { joined_letters } from "../model/machine.js";
import { is_bad, is_expected } from "../model/verdict.js";

export function tally_of(rows) {
  const tally = {
    pass: 0,
    fail: 0,
    "expected-shortfall": 0,
    refuted: 0,
    error: 0,
    "for-information": 0,
    "not-applicable": 0,
    records: rows.length,
    seconds: 0,
    machines: joined_letters(rows.map((row) => row.machine)),
    steps: 0,
    updates: 0,
    closest: null,
    fewest: Infinity,
  };
  const ns = [];
  for (const row of rows) {
    if (row.verdict in tally) ++tally[row.verdict];
    tally.seconds += Number.isFinite(row.seconds) ? row.seconds : 0;
    tally.steps += row.steps;
    tally.updates += row.updates;
    if (row.ns > 0) ns.push(row.ns);
    if (row.fewest !== null) tally.fewest = Math.min(tally.fewest, row.fewest);
    if (is_expected(row.verdict)) continue; // stated beforehand to be beyond
    if (row.check && (!tally.closest || row.check.margin > tally.closest.check.margin))
      tally.closest = row;
  }
  tally.bad = rows.filter((row) => is_bad(row.verdict)).length;
  tally.median_ns = ns.length > 0 ? ns.sort((a, b) => a - b)[ns.length >> 1] : 0;
  return tally;
}
