// SPDX-License-Identifier: GPL-3.0-or-later
// Records tell no suite; its families do.

const STABILITY = /^(perturbed|ladder|gauntlet)\//;

/** What the search finds a case by beside its own words. */
export const suite_of = (case_name) => (STABILITY.test(case_name) ? "stability" : "");
