// SPDX-License-Identifier: GPL-3.0-or-later
// Perturbed cases: perturbed/CASE runs a case as it must not matter (turned, moved, renumbered …); each of its
// checks is a group of perturbations and tells how many digits survive them.

const FOLDER = "perturbed/";
/** The setting by which a record says that it is perturbed itself (kPerturbedSetting in reports/record/record.h). */
export const PERTURBED = "perturbed";
const LACKING = ": not applicable: ";

export const is_perturbed = (case_name) => case_name.startsWith(FOLDER);

/** The case that was perturbed. */
export const perturbed_of = (case_name) => case_name.slice(FOLDER.length);

/** Map from the groups that a record leaves out to why. */
export const lacking_of = ({ notes }) =>
  new Map(
    notes
      .filter((note) => note.includes(LACKING))
      .map((note) => {
        const [group] = note.split(LACKING, 1);
        return [group, note.slice(group.length + LACKING.length)];
      }),
  );

/**
 * All groups, in the records' order: one that the first record lacks stands behind the one that another
 * record has before it.
 */
export function groups_of(records) {
  const groups = [];
  for (const { checks } of records) {
    let place = 0;
    for (const { quantity } of checks) {
      const known = groups.indexOf(quantity);
      if (known < 0) groups.splice(place, 0, quantity);
      place = (known < 0 ? place : known) + 1;
    }
  }
  const lacked = records.flatMap((record) => [...lacking_of(record).keys()]);
  return [...new Set([...groups, ...lacked])];
}

// The words of a perturbation, at the end of `worst` behind "when", or before what broke it, and its name, as
// validation/stability/perturbation.cpp has both; $1 is what the words tell.
const NAMES = [
  [/run again/, "rerun"],
  [
    /each step taken, taken back and taken again|steps were not the same when taken again/,
    "rewind",
  ],
  [/turned by 90° about/, "turned/1"],
  [/turned by 40° about/, "turned/2"],
  [/turned by -115° about/, "turned/3"],
  [/moved (\S+) m away/, "moved/$1"],
  [/mirrored at a plane/, "mirrored"],
  [/bodies and obstacles in another order, seed (\d+)/, "bodies/$1"],
  [/vertices and tetrahedra in another order, seed (\d+)/, "vertices/$1"],
  [/lengths × \S+ masses ×/, "units"],
  [/everything at \S+ m\/s more/, "drifting"],
  [/the engine's arithmetic rounds (\S+)/, "rounding/$1"],
  [/each number of the scene .* off, seed (\d+)/, "ulp/$1"],
  [/a·b \+ c rounded once/, "fused"],
  [/the engine built in single precision/, "single"],
].map(([words, name]) => [new RegExp(`(?:^|, when |^\\d+ )(?:${words.source})`), name]);

export const PERTURBATION_NAMES = NAMES.map(([, name]) => name);

/** The perturbation that `worst` of a check tells of, as --perturb takes it; "" where it tells of none. */
export function perturbation_of({ worst }) {
  for (const [words, name] of NAMES) {
    const found = words.exec(worst);
    if (found) return name.replace("$1", () => (found[1] ?? "").replace(/[:,;]+$/, ""));
  }
  return "";
}
