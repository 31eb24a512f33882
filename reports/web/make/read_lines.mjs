// SPDX-License-Identifier: GPL-3.0-or-later
import { closeSync, openSync, readSync } from "node:fs";
import { StringDecoder } from "node:string_decoder";

const CHUNK = 1 << 22;

/**
 * Calls `line_read(text, number, complete)` for each line of a file, whatever its size; `complete` is
 * false for a last line without its line break. A line above `longest` characters is an error.
 */
export function read_lines(file, line_read, longest = 2 ** 28) {
  const descriptor = openSync(file, "r");
  try {
    const decoder = new StringDecoder("utf8");
    const buffer = Buffer.alloc(CHUNK);
    let rest = "";
    let number = 0;
    for (let size; (size = readSync(descriptor, buffer)) > 0;) {
      const text = rest + decoder.write(buffer.subarray(0, size));
      let start = 0;
      for (let end; (end = text.indexOf("\n", start)) >= 0; start = end + 1) {
        line_read(text.slice(start, end), ++number, true);
      }
      rest = text.slice(start);
      if (rest.length > longest) throw new Error(`line ${number + 1} is too long to be a record`);
    }
    rest += decoder.end();
    if (rest.trim() !== "") line_read(rest, ++number, false);
  } finally {
    closeSync(descriptor);
  }
}
