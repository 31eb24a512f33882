// SPDX-License-Identifier: GPL-3.0-or-later
import { existsSync, readFileSync } from "node:fs";
import { basename, join, normalize, sep } from "node:path";
import { decode_frames } from "../model/frames.js";

// A record names a file inside its run's folder; anything else is refused.
function path_within(folder, name) {
  const path = normalize(name);
  if (path.startsWith("..") || path.startsWith(sep) || path.includes("\0")) return null;
  return join(folder, path);
}

/**
 * The frames files that the runs' records name: {recordings: [{name, bytes}], warnings}. Each record's
 * `frames` becomes the recording's name in the page; empty when the file is missing or broken.
 */
export function read_recordings(runs) {
  const recordings = [];
  const warnings = [];
  const names = new Map();
  for (const run of runs) {
    for (const record of run.records) {
      if (record.frames === "") continue;
      const path = path_within(run.folder, record.frames);
      record.frames = path ? load(path) : refuse(record.frames, "stands outside the run's folder");
    }
  }
  return { recordings, warnings };

  function load(path) {
    if (names.has(path)) return names.get(path);
    let name = "";
    try {
      if (!existsSync(path)) throw new Error("is missing");
      const bytes = readFileSync(path);
      decode_frames(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
      name = String(recordings.length);
      recordings.push({ name, bytes });
    } catch (error) {
      refuse(basename(path), error.message);
    }
    names.set(path, name);
    return name;
  }

  function refuse(name, why) {
    warnings.push(`The recording ${name} ${why}; the case is shown without it.`);
    return "";
  }
}
