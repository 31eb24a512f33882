// SPDX-License-Identifier: GPL-3.0-or-later
// axe-core finds no fault of weight, in light and dark, wide and narrow.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axe_source, draw_plots, start_browser, turn_to } from "./browser.mjs";
import { lines_of, make_run, varied_records } from "./records.mjs";
import { make_page } from "./report.mjs";

let browser;
let file;
before(async () => {
  browser = await start_browser();
  const run = make_run(lines_of(varied_records()));
  file = make_page(run, "--against", make_run(lines_of(varied_records().slice(2)), "before"));
});
after(() => browser.close());

const VIEWS = [
  "#summary",
  "#cases",
  "#case=incline/stop/mu=0.3",
  "#case=clamp/hold",
  "#family=incline/threshold",
  "#plots",
  "#compare",
  "#about",
];

for (const [name, options] of Object.entries({
  light: {},
  dark: { dark: true },
  narrow: { width: 400, height: 800 },
})) {
  test(`axe finds nothing serious: ${name}`, async () => {
    const page = await browser.open(file, options);
    await page.evaluate(axe_source);
    const found = [];
    for (const hash of VIEWS) {
      await turn_to(page, hash);
      await draw_plots(page);
      const { violations } = await page.evaluate(() =>
        globalThis.axe.run(document, { resultTypes: ["violations"] }),
      );
      for (const { id, impact, nodes } of violations) {
        if (["serious", "critical"].includes(impact))
          found.push(
            `${hash}: ${id}: ${nodes
              .slice(0, 3)
              .map(
                ({ html, failureSummary }) =>
                  `${html.slice(0, 160)} ${failureSummary.slice(0, 200)}`,
              )
              .join(" | ")}`,
          );
      }
    }
    assert.deepEqual(found, []);
  });
}
