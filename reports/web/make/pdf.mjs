// SPDX-License-Identifier: GPL-3.0-or-later
// HTML → PDF by a browser of the Chromium family, where one is installed.
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { pathToFileURL } from "node:url";

const NAMES = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
const MOST_TIME = 300_000; // ms

function browser() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  const folders = (process.env.PATH ?? "").split(delimiter).filter(Boolean);
  return folders
    .flatMap((folder) => NAMES.map((name) => join(folder, name)))
    .find((file) => existsSync(file));
}

/** The bytes of a page's PDF. Throws one sentence when there is no browser or it fails. */
export function pdf_of(html) {
  const program = browser();
  if (!program || !existsSync(program))
    throw new Error(
      "a PDF needs Chromium (Debian: chromium), which is not installed; --manual FILE.html needs nothing",
    );
  const folder = mkdtempSync(join(tmpdir(), "stiction-manual-"));
  try {
    const [page, pdf] = [join(folder, "manual.html"), join(folder, "manual.pdf")];
    writeFileSync(page, html);
    const { status, error, stderr } = spawnSync(
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
      { encoding: "utf8", timeout: MOST_TIME },
    );
    if (!existsSync(pdf)) {
      const why = error?.message ?? stderr.trim().split("\n").at(-1) ?? `exit code ${status}`;
      throw new Error(`${program} made no PDF: ${why}`);
    }
    return readFileSync(pdf);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
