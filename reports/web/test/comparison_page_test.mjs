// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a comparison in a browser.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { after, before, test } from "node:test";
import { axe_source, draw_plots, start_browser, turn_to } from "./browser.mjs";
import { compared_records, FINDINGS } from "./compared_records.mjs";
import { lines_of, make_run, record } from "./records.mjs";
import { make_page, report } from "./report.mjs";
import { temporary_folder } from "./temporary.mjs";

let browser;
let run;
let file;
before(async () => {
  browser = await start_browser({ webgl: false });
  run = make_run(lines_of(compared_records()));
  file = make_page(run);
});
after(() => browser.close());

async function accessible(page) {
  await page.evaluate(axe_source);
  const { violations } = await page.evaluate(() =>
    globalThis.axe.run(document, { resultTypes: ["violations"] }),
  );
  const grave = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
  assert.deepEqual(
    grave.map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 160)}`),
    [],
  );
}

test("the summary has the winners first, then the findings and where rules fail", async () => {
  for (const dark of [false, true]) {
    const page = await browser.open(file, { dark });
    const findings = await page.locator(".findings li").allInnerTexts();
    assert.deepEqual(findings, FINDINGS);
    const tops = await page
      .locator(".winners-part, .findings")
      .evaluateAll((parts) => parts.map((part) => part.getBoundingClientRect().top));
    assert.ok(tops[0] < 300 && tops[1] > tops[0], tops.join());
    const slab = page.locator("table.winners tr", { hasText: "rules/slab" }).first();
    assert.match(await slab.innerText(), /m\/s[^]*then/);
    assert.match(
      await page.locator("h1").innerText(),
      /^8 rules side by side in 9 cases; 20 runs failed\.$/,
    );
    await page.locator(".plot-work-precision").waitFor();
    const marks = await draw_plots(page);
    assert.equal(marks.length, 3);
    for (const count of marks) assert.ok(count > 0);
    assert.match(await page.locator(".all-cases").innerText(), /rules\/ball[^\n]*✕ 14 of 14/);
    await accessible(page);
    await page.locator(".findings li a").first().click();
    await page.getByRole("heading", { level: 1, name: "rules/slab" }).waitFor();
    assert.deepEqual(page.faults, []);
  }
});

test("a case: one table, the least of each column marked, 'never' for what was not reached", async () => {
  const page = await browser.open(file, { hash: "#case=rules/membrane" });
  const table = page.locator("table.compared");
  assert.equal(await table.locator("tbody tr").count(), 14);
  assert.equal(await table.locator("tr.failed").count(), 2);
  assert.match(
    await table.locator("tbody tr").last().innerText(),
    /secant ✕ a body moved by 7\.6 mm/,
  );
  assert.equal(await table.locator("tr.failed .best").count(), 0);
  assert.match(await table.innerText(), /never/);
  assert.match(await table.locator(".best").first().innerText(), /◆/);
  await table.getByRole("button", { name: "final creep" }).click();
  assert.equal(await table.locator('th[aria-sort="ascending"]').innerText(), "final creep m/s");
  assert.match(
    await table.locator("tbody tr").first().innerText(),
    /fixed-point, memory = keep\s+quiet/,
  );
  const marks = await draw_plots(page);
  assert.equal(marks.length, 2);
  assert.match(await page.locator(".case-title").innerText(), /14 side by side, ✕ 2 fail/);
  await accessible(page);
  assert.deepEqual(page.faults, []);
});

test("a sweep that fails at some values says so; earlier runs stay in their own view", async () => {
  const both = make_page(run, "--against", make_run(lines_of(compared_records()), "before"));
  const page = await browser.open(both, { hash: "#case=gain/slab" });
  await page.locator("table.compared").waitFor();
  assert.match(
    await page.locator(".case-title").innerText(),
    /2 side by side, ✕ 1 fails at some values/,
  );
  assert.equal(await page.locator("table.compared tbody tr").count(), 2);
  assert.deepEqual(page.faults, []);
});

test("every view draws its plots and stays within 400 px", async () => {
  for (const width of [1280, 400]) {
    const page = await browser.open(file, { width });
    for (const [hash, count] of [
      ["#case=gain/slab", 1],
      ["#case=work/slab/cells=2/dt=1e-4", 0],
      ["#family=work/slab", 3],
      ["#plots=scores", 2],
      ["#cases", 0],
      ["#summary", 3],
    ]) {
      await turn_to(page, hash);
      await page.waitForFunction(
        (wanted) => document.querySelectorAll("main .plot-canvas").length >= wanted,
        count,
      );
      for (const marks of await draw_plots(page)) assert.ok(marks > 0, hash);
      const beyond = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      assert.ok(beyond <= 0, `${hash} is ${beyond} px too wide at ${width} px`);
    }
    assert.deepEqual(page.faults, []);
  }
});

test("the diagrams are SVG files too", () => {
  const folder = temporary_folder();
  const { status, err } = report(run, "--out", `${folder}/page.html`, "--svg", `${folder}/svg`);
  assert.equal(status, 0, err);
  const files = readdirSync(`${folder}/svg`);
  for (const wanted of [
    /^rules_scores-1/,
    /^rules_slab_history-2/,
    /^gain_slab_sweep/,
    /^work_slab_work/,
  ])
    assert.ok(
      files.some((name) => wanted.test(name)),
      `${wanted} is not among ${files}`,
    );
});

test("a run without comparisons has none of it", async () => {
  const page = await browser.open(make_page(make_run(lines_of([record()]))));
  assert.equal(await page.locator(".findings, table.compared").count(), 0);
  assert.equal(await page.locator(".overview .plot-work-precision").count(), 1);
});
