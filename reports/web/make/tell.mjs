// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says, on the standard output and error: lines of text, whatever they quote.
import { writeSync } from "node:fs";
import { one_line } from "./clean_text.mjs";

const COULD_NOT_RUN = 2;

// Of all of the text, or throws.
function write_all(descriptor, text) {
  let rest = Buffer.from(text);
  while (rest.length > 0) {
    try {
      rest = rest.subarray(writeSync(descriptor, rest));
    } catch (error) {
      if (error.code !== "EAGAIN") throw error; // a pipe that is full
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 10); // ms
    }
  }
}

/** A line on the standard error; where nobody can read it, it is lost and nothing else happens. */
export function tell(sentence) {
  try {
    write_all(2, `stiction report: ${one_line(sentence)}\n`);
  } catch {
    // Nobody can be told.
  }
}

/** Lines on the standard output. Where they cannot be written the program ends with exit code 2. */
export function show(text) {
  try {
    write_all(1, `${text.split("\n").map(one_line).join("\n")}\n`);
  } catch (error) {
    // Who has closed a pipe knows that.
    if (error.code !== "EPIPE") tell("what it says could not be written to the standard output");
    process.exit(COULD_NOT_RUN);
  }
}
