// SPDX-License-Identifier: GPL-3.0-or-later
// Where records were timed: a machine and what the program was built with. Timings of different ones don't
// compare, so each is called by a letter that stands beside whatever was timed there.
import { group_by } from "./family.js";

const known = []; // fingerprints, in the order in which they became known

/** Records with the same one have timings that compare. */
export const fingerprint_of = ({ environment }) =>
  JSON.stringify([environment.machine, environment.toolchain]);

/** Tells the machines of a page, so that each has one letter on all of it. A second call begins anew. */
export function know_machines(fingerprints) {
  known.length = 0;
  known.push(...new Set(fingerprints));
}

/** The fingerprints of some records, each once, in order: for know_machines(). */
export const fingerprints_of = (records) => [...new Set(records.map(fingerprint_of))];

function place_of(fingerprint) {
  if (!known.includes(fingerprint)) known.push(fingerprint);
  return known.indexOf(fingerprint);
}

const letter_at = (place) => (place < 26 ? String.fromCharCode(65 + place) : `M${place + 1}`);

/** "A": what the machine of a fingerprint is called. */
export const letter_of = (fingerprint) => letter_at(place_of(fingerprint));

/** "A": what a record's machine is called, on the page where `index.machines` are known. */
export const machine_letter = (record) => letter_of(fingerprint_of(record));

// Names of fingerprints, as short as tells them apart: the toolchain only where it differs.
function names_of(fingerprints) {
  const told = fingerprints.map(JSON.parse);
  const differ = (i) => new Set(told.map((one) => one[i])).size > 1;
  return told.map(([machine, toolchain]) =>
    differ(1) || !differ(0) ? [machine, toolchain].filter(Boolean).join(", ") : machine,
  );
}

/** [{letter, name, records}] of some records, by letter. */
export function machines_of(records) {
  const groups = [...group_by(records, fingerprint_of)];
  for (const [fingerprint] of groups) place_of(fingerprint); // in the order of the records
  groups.sort(([a], [b]) => place_of(a) - place_of(b));
  const names = names_of(groups.map(([fingerprint]) => fingerprint));
  return groups.map(([fingerprint, own], i) => ({
    letter: letter_at(place_of(fingerprint)),
    name: names[i],
    records: own,
  }));
}

/** The letters of the machines on which some records ran: "A", "A + B". */
export const letters_of = (records) =>
  machines_of(records)
    .map(({ letter }) => letter)
    .join(" + ");

/** Whether some records ran on more than one machine. */
export const is_on_several = (records) => fingerprints_of(records).length > 1;

/** Names with the letters of their records' machines, "quiet · A", where `records` ran on several: (name, record) → name. */
export function machine_names(records) {
  if (!is_on_several(records)) return (name) => name;
  return (name, record) => [name, machine_letter(record)].filter(Boolean).join(" · ");
}

const MOST_NAMED = 6;

function sentence_of(machines) {
  if (machines.length < 2) return "";
  const named = machines.slice(0, MOST_NAMED).map(({ letter, name }) => `${letter}: ${name}`);
  const more = machines.length - named.length;
  return `Timings of ${machines.length} machines, which don't compare: ${[...named, more > 0 && `and ${more} more`].filter(Boolean).join("; ")}.`;
}

/** "Timings of 2 machines, which don't compare: A: …; B: …."; empty where there is one. */
export const timings_sentence = (records) => sentence_of(machines_of(records));

/** The same for machines that know_machines() was told of, by their letters: ["A", "A + B"]. */
export function letters_sentence(letters) {
  const wanted = new Set(letters.flatMap((text) => text.split(" + ")));
  const places = known.map((_, place) => place).filter((place) => wanted.has(letter_at(place)));
  const names = names_of(places.map((place) => known[place]));
  return sentence_of(places.map((place, i) => ({ letter: letter_at(place), name: names[i] })));
}

/** The letters of some of `records`: a function from these to "A + B", "" where all ran on one machine. */
export const machine_letters = (records) => (is_on_several(records) ? letters_of : () => "");

/** "A", "B", "B": "A + B". */
export const joined_letters = (list) => [...new Set(list)].filter(Boolean).sort().join(" + ");
