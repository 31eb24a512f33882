// SPDX-License-Identifier: GPL-3.0-or-later
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const root = mkdtempSync(join(tmpdir(), "stiction-web-"));
process.on("exit", () => rmSync(root, { recursive: true, force: true }));

/** A new folder that goes when the test's process ends. */
export const temporary_folder = () => mkdtempSync(join(root, "t-"));
