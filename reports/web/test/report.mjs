// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the report program as a user does.
import { spawnSync } from "node:child_process";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { temporary_folder } from "./temporary.mjs";

const here = dirname(fileURLToPath(import.meta.url));
export const build = resolve(process.env.STICTION_WEB_BUILD ?? join(here, "../../../build/web"));

/** {status, out, err}. */
export function report(...words) {
  const { status, stdout, stderr } = spawnSync(
    process.execPath,
    [join(build, "report.mjs"), ...words],
    { encoding: "utf8" },
  );
  return { status, out: stdout, err: stderr };
}

/** The page of some runs; throws what the program said when it failed. */
export function make_page(...words) {
  const file = join(temporary_folder(), "report.html");
  const { status, err } = report(...words, "--out", file);
  if (status !== 0 && status !== 1) throw new Error(err); // 1: a comparison in which something is worse
  return file;
}
