// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a run of `./stiction validate`: $STICTION_TEST_RUN, as .ci/run names it.
import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import {
  axe_source,
  draw_plots,
  open_within,
  scroll_to,
  start_browser,
  turn_to,
} from "./browser.mjs";
import { make_page } from "./report.mjs";

const run = process.env.STICTION_TEST_RUN;
const skip = run ? false : "$STICTION_TEST_RUN names no run";
const records = run
  ? readFileSync(join(run, "latest", "records.jsonl"), "utf8")
      .trim()
      .split("\n")
      .map((line) => JSON.parse(line))
  : [];
let browser;
let file;
before(async () => {
  if (skip) return;
  browser = await start_browser();
  file = make_page(run);
});
after(() => browser?.close());

test(
  "the page of a real run is ready in one second, below 15 MB, and says what matters on a screen",
  { skip },
  async () => {
    assert.ok(statSync(file).size < 15e6, `${statSync(file).size} bytes`);
    const page = await open_within(browser, file, 1000);
    console.log(page.told);
    assert.ok(page.in_time, page.told);
    await draw_plots(page);
    const failing = records.filter(
      ({ verdict }) => verdict === "fail" || verdict === "error",
    ).length;
    assert.match(
      await page.locator("h1").getAttribute("class"),
      failing > 0 ? /verdict-(fail|error)/ : /verdict-pass/,
    );
    // All families need not fit, but what the configurations come to, and both pictures' beginnings, must.
    const bottom = await page
      .locator("table.answer .totals")
      .evaluate((part) => part.getBoundingClientRect().bottom + scrollY);
    assert.ok(bottom <= 620, `the totals end at ${bottom} px`);
    for (const canvas of await page.locator(".overview .plot-canvas").all())
      assert.ok((await canvas.boundingBox()).y < 760);
    assert.deepEqual(page.faults, []);
  },
);

// Without WebGL, which draws each of the recordings that are passed by.
test("each case of a real run is shown in words and numbers", { skip }, async () => {
  const flat = await start_browser({ webgl: false });
  try {
    const page = await flat.open(file, { late_ms: 0 }); // each view is waited for by its heading
    const names = [...new Set(records.map((record) => record.case))];
    for (const name of names) {
      await turn_to(page, `#case=${encodeURIComponent(name)}`);
      await page.waitForFunction(
        (wanted) => document.querySelector("h1")?.textContent === wanted,
        name,
      );
      assert.doesNotMatch(
        await page.locator("main").innerText(),
        /cannot be (shown|drawn)|undefined|NaN\b/,
        name,
      );
    }
    assert.deepEqual(page.faults, []);
  } finally {
    await flat.close();
  }
});

test(
  "a recorded case of a real run is shown with its plots, and its recording moves",
  { skip },
  async () => {
    const page = await browser.open(file);
    const recorded = records.find(({ frames }) => frames);
    assert.ok(recorded, "no case was recorded");
    await turn_to(page, `#case=${encodeURIComponent(recorded.case)}`);
    for (const marks of await draw_plots(page)) assert.ok(marks > 0, recorded.case);
    await scroll_to(page.locator(".player"));
    await page.locator(".player[data-loaded]").waitFor();
    const positions = () =>
      page.locator(".player").evaluate((player) => player.stiction_positions()[0].join());
    await page.locator(".player").focus();
    await page.keyboard.press("Home"); // it opens at the moment that tells, which may be the last
    const start = await positions();
    await page.keyboard.press("End");
    assert.notEqual(await positions(), start);
    await page.evaluate(axe_source);
    const { violations } = await page.evaluate(() =>
      globalThis.axe.run(document, { resultTypes: ["violations"] }),
    );
    assert.deepEqual(
      violations
        .filter(({ impact }) => ["serious", "critical"].includes(impact))
        .map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 160)} ${nodes[0].failureSummary}`),
      [],
    );
    assert.deepEqual(page.faults, []);
  },
);
