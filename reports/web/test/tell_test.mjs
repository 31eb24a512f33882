// SPDX-License-Identifier: GPL-3.0-or-later
// What the page's program says, through streams of all kinds.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { closeSync, openSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const TELL = fileURLToPath(new URL("../make/tell.mjs", import.meta.url));
const HOSTILE = "a\u0007\u001b[2J\u009b31m\u061c\u200e\u202e\u2066\r\n\tFORGED\0";

function run(script, stdio = ["ignore", "pipe", "pipe"]) {
  const ended = spawnSync(
    process.execPath,
    ["--input-type=module", "-e", `import { show, tell } from "${TELL}"; ${script}`],
    { stdio, encoding: "utf8" },
  );
  return { code: ended.status, output: ended.stdout, errors: ended.stderr };
}

test("lines are text, whatever they quote", () => {
  const said = run(`tell(${JSON.stringify(HOSTILE)}); show(${JSON.stringify(HOSTILE)} + "\\nend")`);
  assert.equal(said.errors, "stiction report: a[2J31m   FORGED\n");
  assert.equal(said.output, "a[2J31m \n FORGED\nend\n");
  assert.equal(said.code, 0);
});

test("output that cannot be written is exit code 2 and a sentence", () => {
  const full = openSync("/dev/full", "w");
  const said = run(`show("x")`, ["ignore", full, "pipe"]);
  closeSync(full);
  assert.equal(said.code, 2);
  assert.equal(
    said.errors,
    "stiction report: what it says could not be written to the standard output\n",
  );
});

test("whether anyone reads the errors changes nothing", () => {
  const full = openSync("/dev/full", "w");
  const said = run(`tell("x"); show("y")`, ["ignore", "pipe", full]);
  closeSync(full);
  assert.deepEqual([said.code, said.output], [0, "y\n"]);
});
