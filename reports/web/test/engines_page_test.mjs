// SPDX-License-Identifier: GPL-3.0-or-later
// The page of engines side by side in a browser.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axe_source, draw_plots, start_browser, turn_to } from "./browser.mjs";
import { ENGINE_FINDINGS, engine_records, QUESTIONS, ROWS } from "./engine_records.mjs";
import { HOSTILE, lines_of, make_run, record } from "./records.mjs";
import { make_page } from "./report.mjs";

let browser;
let file;
before(async () => {
  browser = await start_browser({ webgl: false });
  file = make_page(make_run(lines_of(engine_records())));
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

test("the summary: findings, then engine × question, then the cheapest ways; nothing shouts", async () => {
  for (const dark of [false, true]) {
    const page = await browser.open(file, { dark });
    assert.equal(
      await page.locator("h1").innerText(),
      "9 engines in 14 configurations side by side, 25 questions.",
    );
    assert.equal(await page.locator("h1.verdict-fail, h1.verdict-error, .failures").count(), 0);
    assert.equal(await page.locator(".findings li").count(), ENGINE_FINDINGS.length);
    assert.equal(await page.locator(".more-findings[open]").count(), 0);
    const matrix = page.locator("table.matrix");
    assert.equal(await matrix.locator("tbody tr").count(), ROWS.length);
    assert.equal(await matrix.locator("tbody td a").count(), ROWS.length * QUESTIONS.length);
    assert.equal(await matrix.locator("thead th").count(), QUESTIONS.length + 2);
    for (const [kind, words] of [
      ["broke", "broke: it was killed by signal 11"],
      ["lacks", "–: the engine turns no bodies"],
      ["never", "never: there is none"],
    ]) {
      const cell = matrix.locator(`td.${kind} a`).first();
      assert.ok((await cell.getAttribute("title")).includes(words));
    }
    assert.match(
      await matrix.locator("thead a").nth(1).getAttribute("title"),
      /^Does it hold in scene 0\? Falling to 1° \(°\)$/,
    );
    assert.match(await page.locator("table.cheapest tbody").first().innerText(), /× 140/);
    await accessible(page);
    assert.deepEqual(page.faults, []);
  }
});

test("a cell leads to its question, where its engine is marked and its command can be copied", async () => {
  const page = await browser.open(file);
  await page.locator("table.matrix tbody tr").nth(9).locator("td a").nth(4).click();
  await page.getByRole("heading", { level: 1, name: "engines/question-4" }).waitFor();
  assert.match(await page.locator(".case-title").innerText(), /12 of 14 answer, 1 never get there/);
  assert.equal(await page.locator("table.compared tbody tr").count(), ROWS.length);
  assert.match(await page.locator("table.compared tr.chosen").innerText(), /^ode · exact/);
  assert.match(await page.locator("table.compared tbody tr").first().innerText(), /^ode · quick/);
  const [marks] = await draw_plots(page);
  assert.ok(marks > 3 * ROWS.length);
  assert.match(await page.locator(".notes").first().innerText(), /dart · dantzig: it was killed/);
  assert.equal(await page.locator(".command").count(), ROWS.length);
  const copy = page.locator(".commands .chosen button");
  await copy.click();
  await page.getByRole("button", { name: /^(Copied|Selected) ?: ode · exact$/ }).waitFor();
  await accessible(page);
  await page.getByRole("link", { name: "next →" }).click();
  await page.getByRole("heading", { level: 1, name: "engines/question-5" }).waitFor();
  assert.match(await page.locator("main").innerText(), /asked with its usual effort alone/);
  await page.getByRole("link", { name: "slope/scene-5/azimuth=5" }).click();
  await page.getByRole("heading", { level: 1, name: "slope/scene-5/azimuth=5" }).waitFor();
  assert.deepEqual(page.faults, []);
});

test("raw answers stand under their cases by engine, configuration and effort", async () => {
  const page = await browser.open(file, { hash: "#case=slope/scene-4/azimuth=4" });
  await page.locator("table.checks").waitFor();
  assert.match(await page.locator("table.checks").innerText(), /bullet · default · effort 2/);
  assert.match(await page.locator(".case-title").innerText(), /^3 broke off, 19 fail, 30 hold/);
  await turn_to(page, "#cases&verdict=pass");
  await page.waitForFunction(() =>
    /of 1,246/.test(document.querySelector(".count-line")?.innerText),
  );
  assert.match(
    await page.locator("table.big .variant").first().innerText(),
    /^bullet · best · effort 0$/,
  );
  assert.deepEqual(page.faults, []);
});

test("the matrix is one stop of the Tab key; arrow keys go on from there", async () => {
  const page = await browser.open(file);
  assert.equal(await page.locator('table.matrix a[tabindex="0"]').count(), 1);
  await page.locator('table.matrix a[tabindex="0"]').focus();
  for (const key of ["ArrowDown", "ArrowDown", "ArrowRight", "End"]) await page.keyboard.press(key);
  const here = () => page.evaluate(() => document.activeElement.title);
  assert.match(await here(), /^bullet · best, question-24: /);
  assert.ok(
    await page.evaluate(() => {
      const cell = document.activeElement.getBoundingClientRect();
      const region = document.querySelector(".matrix-scroll").getBoundingClientRect();
      return cell.left >= region.left && cell.right <= region.right + 1;
    }),
  );
  await page.keyboard.press("Home");
  assert.match(await here(), /^bullet · best, question-0: /);
  await page.keyboard.press("Enter");
  await page.getByRole("heading", { level: 1, name: "engines/question-0" }).waitFor();
  assert.deepEqual(page.faults, []);
});

test("on 360 px every view stays within the page, and the names stay in view", async () => {
  const page = await browser.open(file, { width: 360 });
  for (const hash of [
    "#summary",
    "#case=engines/question-4",
    "#case=engines/question-5",
    "#case=slope/scene-4/azimuth=4",
    "#plots",
    "#cases",
  ]) {
    await turn_to(page, hash);
    for (const marks of await draw_plots(page)) assert.ok(marks > 0, hash);
    const beyond = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    assert.ok(beyond <= 0, `${hash} is ${beyond} px too wide`);
  }
  await turn_to(page, "#summary");
  const left = await page.locator(".matrix-scroll").evaluate((region) => {
    region.scrollLeft = 600;
    return region.querySelector("tbody th").getBoundingClientRect().left;
  });
  assert.ok(left >= 0 && left < 40);
  assert.deepEqual(page.faults, []);
});

test("with other records these are judged first; names are never markup", async () => {
  const hostile = engine_records().map((one) =>
    one.engine === "bullet"
      ? { ...one, engine: HOSTILE, settings: { ...one.settings, configuration: "constructor" } }
      : one,
  );
  const failing = record({ verdict: "fail" });
  const both = make_page(make_run(lines_of(hostile)), make_run(lines_of([failing]), "other"));
  const page = await browser.open(both);
  assert.match(await page.locator("h1").innerText(), /^1 fails, 0 hold/);
  assert.equal(await page.locator(".overview .plot-work-precision").count(), 1);
  assert.equal(await page.locator("table.matrix tbody tr").count(), ROWS.length);
  await page.locator("table.matrix tbody td a").first().click();
  await page.locator(".plot-work-precision svg").waitFor();
  assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
  assert.deepEqual(page.faults, []);
});
