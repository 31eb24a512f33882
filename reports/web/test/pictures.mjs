// SPDX-License-Identifier: GPL-3.0-or-later
// What people see, as pictures to be looked at: the page of a run, its manual, and screens of terminals kept as
// text by validation/terminal_test.py.
//   node reports/web/test/pictures.mjs RUN OUT [SCREENS]
import { mkdirSync, readdirSync, readFileSync } from "node:fs";
import { basename, join } from "node:path";
import { draw_plots, start_browser } from "./browser.mjs";
import { make_page } from "./report.mjs";

const [run, out, screens] = process.argv.slice(2);
if (!run || !out) {
  console.error("usage: pictures.mjs RUN OUT [SCREENS]");
  process.exit(2);
}
mkdirSync(out, { recursive: true });
const browser = await start_browser();
const file = make_page(run);
const keep = (page, name, options = {}) =>
  page.screenshot({ path: join(out, `${name}.png`), ...options });

const VIEWS = [
  ["summary", ""],
  ["case", "#case=paper/fig5-box-pyramid"],
  ["cases", "#cases"],
  ["stability", "#stability"], // of a run of --suite stability
  ["about", "#about"],
];
for (const [look, options] of [
  ["1400", {}],
  ["390", { width: 390 }],
  ["dark", { dark: true }],
]) {
  for (const [view, hash] of VIEWS) {
    const page = await browser.open(file, { ...options, hash });
    await draw_plots(page);
    await page.evaluate(() => scrollTo(0, 0));
    const player = page.locator(".player");
    if ((await player.count()) > 0)
      await page.locator(".player[data-loaded]").waitFor({ timeout: 20_000 });
    await keep(page, `page-${view}-${look}`);
    await page.context().close();
  }
}

const printed = await browser.open(file);
await draw_plots(printed);
await printed.emulateMedia({ media: "print" });
await keep(printed, "page-summary-print", { fullPage: true });

// Text as a terminal shows it.
const page = await browser.open(file);
const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
for (const name of screens ? readdirSync(screens).filter((one) => one.endsWith(".txt")) : []) {
  const text = readFileSync(join(screens, name), "utf8");
  await page.setContent(
    `<body><pre style="font:14px/1.25 monospace;background:#111;color:#eee;padding:10px;display:inline-block;margin:0">${escaped(text)}</pre>`,
  );
  await page.locator("pre").screenshot({ path: join(out, `terminal-${basename(name, ".txt")}.png`) });
}
await browser.close();
console.log(`${readdirSync(out).length} pictures in ${out}`);
