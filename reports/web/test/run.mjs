// SPDX-License-Identifier: GPL-3.0-or-later
// npm test: builds with the test packages, then runs every *_test.mjs, or those named.
import { spawnSync } from "node:child_process";
import { readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const run = (...words) => spawnSync(process.execPath, words, { stdio: "inherit" }).status ?? 1;

const built = run(join(here, "..", "build.mjs"), "--tests");
if (built !== 0) process.exit(built);
const wanted = process.argv.slice(2);
const files = readdirSync(here).filter(
  (name) =>
    name.endsWith("_test.mjs") &&
    (wanted.length === 0 || wanted.some((word) => name.includes(word))),
);
process.exit(run("--test", ...files.sort().map((name) => join(here, name))));
