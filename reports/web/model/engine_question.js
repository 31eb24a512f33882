// SPDX-License-Identifier: GPL-3.0-or-later
// What engines were asked, in whole sentences.

// "Does it creep? Falling to 0°" → "Does it creep?"
const stem_of = (words) => words.slice(0, words.lastIndexOf("?") + 1);

const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

// "creep-30" → "creep": questions that go on with one another share it.
const subject_of = (id) => id.split("-")[0];

/**
 * Questions that go on with the one before, "… falling to 30°", as sentences that stand alone; where the
 * one before was not asked, the title of their case. `asked`: [{id, title, case_title}] in order.
 */
export function whole_questions(asked) {
  let before = { id: "", stem: "" };
  return asked.map(({ id, title, case_title }) => {
    if (!title.startsWith("…")) {
      before = { id, stem: stem_of(title) };
      return title;
    }
    const goes_on = before.stem !== "" && subject_of(before.id) === subject_of(id);
    const rest = capital(title.slice(1).trim());
    return goes_on ? `${before.stem} ${rest}` : capital(case_title) || rest;
  });
}
