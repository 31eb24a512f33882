// SPDX-License-Identifier: GPL-3.0-or-later
// What engines were asked, in whole sentences.

// "Does it creep? Falling to 0°" → "Does it creep?"
const stem_of = (words) => words.slice(0, words.lastIndexOf("?") + 1);

const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/**
 * Questions that go on with the one before, "… falling to 30°", as sentences that stand alone. `titles` in
 * the order in which they were asked.
 */
export function whole_questions(titles) {
  let stem = "";
  return titles.map((title) => {
    if (!title.startsWith("…")) {
      stem = stem_of(title);
      return title;
    }
    const rest = capital(title.slice(1).trim());
    return stem ? `${stem} ${rest}` : rest;
  });
}
