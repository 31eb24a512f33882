// SPDX-License-Identifier: GPL-3.0-or-later
import { existsSync, mkdirSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { dirname, resolve } from "node:path";

// Not mkdir's own `recursive`: below /proc it never ends (node 18 and 20).
export function make_folder(path) {
  if (existsSync(path)) return;
  make_folder(dirname(resolve(path)));
  mkdirSync(path);
}

/** Writes a file completely or not at all: an older one stays until the new one is whole. */
export function write_whole(file, text) {
  const partial = `${file}.partial`;
  try {
    make_folder(dirname(file));
    writeFileSync(partial, text);
    renameSync(partial, file);
  } catch (error) {
    rmSync(partial, { force: true });
    throw new Error(`cannot write ${file}: ${error.message}`);
  }
}
