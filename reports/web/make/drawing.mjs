// SPDX-License-Identifier: GPL-3.0-or-later
// Problems that were read and not run (validate --check-only), drawn.
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { e } from "../sketch/tree.js";
import { document_html } from "./document.mjs";
import { problem_part } from "./manual_parts.mjs";

const FILE = "problems.json";

/** The problems that a folder holds, [{case, title, problem}]; null where it holds none. */
export function read_problems(folder) {
  const file = join(folder, FILE);
  if (!existsSync(file)) return null;
  try {
    const problems = JSON.parse(readFileSync(file, "utf8"));
    if (Array.isArray(problems)) return problems;
  } catch {
    // told below
  }
  throw new Error(`${file} is no list of problems`);
}

const article = (one) =>
  e(
    "article",
    {},
    e("h2", {}, String(one.case)),
    e("p", {}, String(one.title)),
    problem_part(one, () => new Map()),
  );

/** A page of drawings, each with its data. */
export const drawing_html = (problems, style) =>
  document_html("Problems as they were read", style, [
    e("h1", {}, "Problems as they were read"),
    ...problems.map(article),
  ]);
