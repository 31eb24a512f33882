// SPDX-License-Identifier: GPL-3.0-or-later
// npm test: builds with the test packages, then runs every *_test.mjs, or those named: as many at a time as there are
// processors where one holds a page to a time, else one more, for each waits for its browser now and then.
import { spawn } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
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
async function run_all(list, at_a_time) {
  const left = [...list];
  const work = async () => {
    for (let file = left.shift(); file; file = left.shift()) {
      // Awaited before `worst` is read: another worker may have changed it meanwhile.
      const code = await run("--test", join(here, file));
      worst = Math.max(worst, code);
    }
  };
  await Promise.all(Array.from({ length: at_a_time }, work));
}

const holds_to_a_time = (file) =>
  /\b(time_of|open_within)\(/.test(readFileSync(join(here, file), "utf8"));
const timed = files.filter(holds_to_a_time);
const processors = availableParallelism();
await run_all(timed, processors);
await run_all(
  files.filter((file) => !timed.includes(file)),
  processors + 1,
);
process.exit(worst);
