// SPDX-License-Identifier: GPL-3.0-or-later
// npm test: builds with the test packages, then runs every *_test.mjs, or those named: one more at a time than there
// are processors, for each waits for its browser now and then.
import { spawn } from "node:child_process";
import { readdirSync } from "node:fs";
import { availableParallelism } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));

// What it printed is shown in one piece when it has ended.
function run(...words) {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, words, { stdio: ["ignore", "pipe", "pipe"] });
    const told = [];
    for (const stream of [child.stdout, child.stderr]) stream.on("data", (text) => told.push(text));
    child.on("close", (code) => {
      process.stdout.write(Buffer.concat(told));
      resolve(code ?? 1);
    });
  });
}

if ((await run(join(here, "..", "build.mjs"), "--tests")) !== 0) process.exit(2);
const wanted = process.argv.slice(2);
const files = readdirSync(here).filter(
  (name) =>
    name.endsWith("_test.mjs") &&
    (wanted.length === 0 || wanted.some((word) => name.includes(word))),
);

let worst = 0;
async function work() {
  for (let file = files.shift(); file; file = files.shift()) {
    // Awaited before `worst` is read: the other worker may have changed it meanwhile.
    const code = await run("--test", join(here, file));
    worst = Math.max(worst, code);
  }
}
await Promise.all(Array.from({ length: availableParallelism() + 1 }, work));
process.exit(worst);
