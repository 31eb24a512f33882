// SPDX-License-Identifier: GPL-3.0-or-later
// The order of runs, by the names of their folders.

// "2025-11-20T23-41-05Z", and "-2" behind it for the second of that second.
const RUN_FOLDER = /^(\d{4}-\d\d-\d\dT\d\d-\d\d-\d\dZ)(?:-(\d+))?$/;

export const is_run_name = (name) => RUN_FOLDER.test(name);

function place(name) {
  const [, time, number] = RUN_FOLDER.exec(name) ?? ["", name, 0];
  return { time, number: Number(number ?? 1) };
}

/** For sorting names, those of later runs first. */
export function newest_first(one, other) {
  const [a, b] = [place(one), place(other)];
  return a.time === b.time ? b.number - a.number : a.time < b.time ? 1 : -1;
}
