// SPDX-License-Identifier: GPL-3.0-or-later
// What a comparison says in plain words: the notes of its record of this name.
import { ENGINE_FINDINGS } from "./engine.js";

export const is_findings = ({ case: name }) => name === "findings" || name === ENGINE_FINDINGS;

const TOPIC = /^([\w-]+)\/[^\s:,]+/;
const LONGEST_LEAD = 120; // letters

/** A note's lead, up to its colon, and the rest: ["rules/slab:", " 1e-9 m/s within …"]. */
export function parted(note) {
  const colon = note.indexOf(": ");
  return colon > 0 && colon < LONGEST_LEAD
    ? [note.slice(0, colon + 1), note.slice(colon + 1)]
    : ["", note];
}

/** Notes by what they are about: [[topic, notes]], "" first: those about no single case. */
export function by_topic(notes) {
  const groups = new Map([["", []]]);
  for (const note of notes) {
    const topic = TOPIC.exec(note)?.[1] ?? "";
    groups.set(topic, [...(groups.get(topic) ?? []), note]);
  }
  return [...groups].filter(([, list]) => list.length > 0);
}
