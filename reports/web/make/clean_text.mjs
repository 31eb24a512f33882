// SPDX-License-Identifier: GPL-3.0-or-later
// Text of records is not trusted: another engine or a broken disk may have written it.

// Control characters, and those that turn the direction of the text around them.
const UNSEEN = /[\u0000-\u001f\u007f-\u009f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]/g;

// The same in a line of JSON, or an escape that could stand for one. Nearly no line has any.
const SUSPICIOUS = /[\u007f-\u009f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]|\\[bfnrtu]/;

/** The text on one line, without unseen characters. */
export const one_line = (text) =>
  text.replace(UNSEEN, (sign) => ("\t\n\r\u2028\u2029".includes(sign) ? " " : ""));

function cleaned(value) {
  if (typeof value === "string") return one_line(value);
  if (Array.isArray(value)) return value.map(cleaned);
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(
    Object.entries(value).map(([name, entry]) => [cleaned(name), cleaned(entry)]),
  );
}

/** The value that a line of JSON was parsed to, its texts on one line and without unseen characters. */
export const clean = (value, line) => (SUSPICIOUS.test(line) ? cleaned(value) : value);
