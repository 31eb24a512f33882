// SPDX-License-Identifier: GPL-3.0-or-later
// HTML → PDF by a browser of the Chromium family, where one is installed.
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { pathToFileURL } from "node:url";
import { write_whole } from "./files.mjs";

const NAMES = [
  "chromium",
  "chromium-browser",
  "google-chrome",
  "google-chrome-stable",
  "chromium-headless-shell",
];
const MOST_TIME = 300_000; // ms

function browser() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  const folders = (process.env.PATH ?? "").split(delimiter).filter(Boolean);
  return folders
    .flatMap((folder) => NAMES.map((name) => join(folder, name)))
    .find((file) => existsSync(file));
}

// A browser's program and those that it starts: its exit code, or why there is none. They end with this
// program, as does the folder.
function run(program, words, folder) {
  return new Promise((resolve) => {
    const child = spawn(program, words, {
      detached: true, // a group of its own, to be ended with what it starts
      stdio: ["ignore", "ignore", "pipe"],
      env: { ...process.env, TMPDIR: folder },
    });
    let errors = "";
    const end = () => {
      try {
        process.kill(-child.pid, "SIGKILL");
      } catch {
        // All have ended.
      }
    };
    const clear = () => {
      end();
      rmSync(folder, { recursive: true, force: true, maxRetries: 3 });
    };
    process.once("exit", clear);
    const patience = setTimeout(() => {
      errors += `it took more than ${MOST_TIME / 1000} s`;
      end();
    }, MOST_TIME);
    const finish = (why) => {
      clearTimeout(patience);
      process.off("exit", clear);
      if (child.pid) end();
      resolve(why ?? errors.trim().split("\n").at(-1));
    };
    child.stderr?.on("data", (bytes) => (errors += bytes));
    child.once("error", (error) => finish(error.message));
    child.once("close", (code) => finish(errors.trim() ? undefined : `exit code ${code}`));
  });
}

/** The bytes of a page's PDF. Rejects with one sentence when there is no browser or it fails. */
export async function pdf_of(html) {
  const program = browser();
  if (!program || !existsSync(program))
    throw new Error(
      "a PDF needs Chromium (Debian: chromium), which is not installed; --manual FILE.html needs nothing",
    );
  const folder = mkdtempSync(join(tmpdir(), "stiction-manual-"));
  try {
    const [page, pdf] = [join(folder, "manual.html"), join(folder, "manual.pdf")];
    write_whole(page, html);
    const why = await run(
      program,
      [
        "--headless",
        "--disable-gpu",
        "--no-pdf-header-footer",
        ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []), // root has no other way
        `--user-data-dir=${join(folder, "profile")}`,
        `--print-to-pdf=${pdf}`,
        pathToFileURL(page).href,
      ],
      folder,
    );
    if (!existsSync(pdf)) throw new Error(`${program} made no PDF: ${why}`);
    return readFileSync(pdf);
  } finally {
    rmSync(folder, { recursive: true, force: true, maxRetries: 3 });
  }
}
