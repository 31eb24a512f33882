// SPDX-License-Identifier: GPL-3.0-or-later
// Strings of records are shown as text, whatever they hold.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { draw_plots, start_browser, turn_to } from "./browser.mjs";
import { hostile_records, lines_of, make_run } from "./records.mjs";
import { make_page } from "./report.mjs";

let browser;
before(async () => (browser = await start_browser({ webgl: false })));
after(() => browser.close());

test("markup in names stays text in every view", async () => {
  const run = make_run(lines_of(hostile_records()));
  const file = make_page(
    run,
    "--against",
    make_run(lines_of(hostile_records()), "before"),
    "--title",
    `</title><script>globalThis.hacked=1</script>`,
  );
  const page = await browser.open(file);
  const links = await page
    .locator("main a")
    .evaluateAll((all) => all.map((link) => link.getAttribute("href")));
  for (const hash of ["#summary", "#cases", "#plots", "#compare", "#about", ...links]) {
    await turn_to(page, hash);
    await draw_plots(page);
    assert.doesNotMatch(
      await page.locator("main").innerText(),
      /There is no such|cannot be (shown|drawn)/,
      hash,
    );
  }
  assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
  assert.equal(await page.locator("img").count(), 0);
  await turn_to(page, "#summary");
  assert.match(await page.title(), /<script>/);
  await turn_to(
    page,
    links.find((href) => href.startsWith("#case=")),
  );
  await page.locator(".claim").waitFor();
  const text = await page.locator("main").innerText();
  assert.match(text, /<img src=x onerror=/);
  assert.match(text, /__proto__/);
  assert.doesNotMatch(text, /[\u202a-\u202e]/);
  assert.deepEqual(page.faults, []);
});

test("tooltips show text", async () => {
  const page = await browser.open(make_page(make_run(lines_of(hostile_records()))));
  await draw_plots(page);
  await page.locator(".overview .plot-work-precision .role-mark.mark-symbol path").last().hover();
  await page.locator(".tip:not([hidden])").waitFor();
  assert.match(await page.locator(".tip").innerText(), /<img src=x/);
  assert.equal(await page.locator(".tip img").count(), 0);
});
