// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { draw_plots, open_within, start_browser, turn_to } from "./browser.mjs";
import { lines_of, make_run, record, varied_records } from "./records.mjs";
import { make_page } from "./report.mjs";

let browser;
let file;
before(async () => {
  browser = await start_browser();
  file = make_page(make_run(lines_of(varied_records())), "--title", "A varied run");
});
after(() => browser.close());

const unfaulted = (page) => assert.deepEqual(page.faults, []);
const wide_overflow = (page) =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

test("the summary says what holds and names failures first, on one screen", async () => {
  const page = await browser.open(file);
  assert.equal(await page.title(), "A varied run");
  assert.match(await page.locator("h1").innerText(), /2 fail, 1 broke off, 5 hold/);
  const failures = await page.locator(".failure-name a").allInnerTexts();
  assert.deepEqual(failures, ["pyramid/four-balls", "drop/odd", "clamp/hold"]);
  assert.match(
    await page.locator(".failure").nth(2).innerText(),
    /creep 0\.002 m\/s instead of 0 m\/s; error 0\.002 m\/s, allowed 1e-06 m\/s/,
  );
  assert.ok((await draw_plots(page))[0] > 3);
  const bottom = await page
    .locator(".overview")
    .evaluate((element) => element.getBoundingClientRect().bottom + scrollY);
  assert.ok(bottom <= 900, `the summary ends at ${bottom} px`);
  unfaulted(page);
});

test("the page is ready in a second", async () => {
  const page = await open_within(browser, file, 1000);
  assert.ok(page.in_time, page.told);
});

test("every view draws its plots", async () => {
  const page = await browser.open(file);
  const expected = {
    "#case=incline/stop/mu=0.3": 4,
    "#family=incline/threshold": 2,
    "#family=incline/stop": 1,
    "#plots=threshold": 1,
    "#plots=work-precision": 1,
  };
  for (const [hash, count] of Object.entries(expected)) {
    await turn_to(page, hash);
    await page.waitForFunction(
      (wanted) => document.querySelectorAll("main .plot-canvas").length === wanted,
      count,
    );
    const marks = await draw_plots(page);
    assert.equal(marks.length, count, hash);
    for (const one of marks) assert.ok(one > 0, `${hash}: a plot has no marks`);
  }
  unfaulted(page);
});

test("a case tells its claim, formula, values, tolerance and reason", async () => {
  const page = await browser.open(file, { hash: "#case=incline/stop/mu=0.3" });
  const text = await page.locator("main").innerText();
  for (const part of [
    "incline/stop/mu=0.3",
    "a sliding box stops",
    "d = v₀²/(2μg)",
    "0.3001",
    "0.3 m: Coulomb's law (closed form)",
    "0.00033",
    "0.001 rel: half a step of travel",
    "paper, fixed point",
    "paper, no memory",
    "0123456789abcdef",
    "1,000",
    "4,000",
  ]) {
    assert.ok(text.includes(part), part);
  }
  assert.match(
    await page.locator("figure[data-plot*=convergence] figcaption").innerText(),
    /observed order 1\.000/,
  );
  assert.match(
    await page.locator("figure[data-plot*=scaling] figcaption").innerText(),
    /exponent 1\.000/,
  );
});

test("a link leads to its case, and an unknown case is told", async () => {
  const page = await browser.open(file, { hash: "#case=clamp/hold" });
  assert.equal(await page.locator("h1").innerText(), "clamp/hold");
  assert.match(await page.locator("main").innerText(), /corner 3/);
  await turn_to(page, "#case=no/such");
  await page.getByText("There is no such case").waitFor();
  await turn_to(page, "#nonsense");
  await page.locator(".view-summary").waitFor();
  unfaulted(page);
});

test("every link of the page leads somewhere", async () => {
  const page = await browser.open(file);
  const hashes = new Set();
  for (const view of ["#summary", "#cases", "#plots", "#about", "#family=incline/stop"]) {
    await turn_to(page, view);
    for (const href of await page
      .locator("main a[href]")
      .evaluateAll((links) => links.map((link) => link.getAttribute("href"))))
      hashes.add(href);
  }
  assert.ok(hashes.size > 15);
  for (const hash of hashes) {
    assert.match(hash, /^#/);
    await turn_to(page, hash);
    assert.doesNotMatch(
      await page.locator("main").innerText(),
      /There is no such|cannot be shown/,
      hash,
    );
  }
  unfaulted(page);
});

test("records are searched, filtered and sorted, and the address keeps it", async () => {
  const page = await browser.open(file, { hash: "#cases" });
  const cases = () => page.locator(".c-case a").allInnerTexts();
  assert.equal((await cases()).length, 10);
  assert.equal((await cases())[0], "pyramid/four-balls");
  await page.locator("#search").fill("threshold mu=0.5");
  await page.waitForFunction(() => document.querySelectorAll(".c-case a").length === 1);
  assert.match(await page.evaluate(() => location.hash), /q=threshold%20mu=0\.5/);
  await page.getByRole("button", { name: "Clear" }).click();
  await page.locator('.toggle[data-verdict="fail"]').click();
  await page.waitForFunction(() => document.querySelectorAll(".c-case a").length === 2);
  assert.equal(
    await page.locator('.toggle[data-verdict="fail"]').getAttribute("aria-pressed"),
    "true",
  );
  await page.getByRole("button", { name: "Clear" }).click();
  await page.getByRole("button", { name: "|Error| ÷ tolerance" }).click();
  await page.locator('th[aria-sort="descending"]').waitFor();
  assert.match(await page.evaluate(() => location.hash), /sort=-margin/);
  assert.deepEqual((await cases()).slice(0, 2), ["drop/odd", "clamp/hold"]);
  assert.equal(await page.locator('th[aria-sort="descending"]').count(), 1);
  await page.reload();
  await page.waitForSelector("[data-ready]");
  assert.equal((await cases())[0], "drop/odd");
  unfaulted(page);
});

test("keys lead through the page", async () => {
  const page = await browser.open(file);
  await page.keyboard.press("2");
  await page.locator(".view-cases").waitFor();
  await page.keyboard.press("j");
  await page.keyboard.press("j");
  await page.keyboard.press("Enter");
  await page.getByRole("heading", { level: 1, name: "clamp/hold" }).waitFor();
  await page.keyboard.press("n");
  await page.getByRole("heading", { level: 1, name: "drop/odd" }).waitFor();
  await page.keyboard.press("Escape");
  await page.locator(".view-cases").waitFor();
  await page.keyboard.press("/");
  await page.waitForFunction(() => document.activeElement?.id === "search");
  await page.keyboard.type("j2");
  assert.equal(await page.locator("#search").inputValue(), "j2");
  await page.keyboard.press("Escape");
  await page.keyboard.press("?");
  await page.locator("dialog[open]").waitFor();
  unfaulted(page);
});

test("clicking a mark of work and precision opens its case", async () => {
  const page = await browser.open(file);
  await draw_plots(page);
  await page.locator(".overview .plot-work-precision .role-mark.mark-symbol path").last().click();
  await page.locator(".view-case").waitFor();
});

test("the matrix tells per configuration and family what holds, and leads to the cases", async () => {
  const page = await browser.open(file);
  const heads = await page.locator("table.answer thead th").allInnerTexts();
  assert.deepEqual(
    heads.slice(1).map((text) => text.trim()),
    ["paper, fixed point", "paper, no memory"],
  );
  const row = (name) => page.locator("table.answer tr", { hasText: name });
  assert.match(await row("Holds").first().innerText(), /4 of 7[^]*1 of 1/);
  assert.match(await row("clamp/hold").innerText(), /fails\s+1\s+2000 ×/);
  assert.match(await row("drop/odd").innerText(), /≥ 1e6 ×/);
  assert.equal(await row("incline/threshold").isVisible(), false);
  await page.locator("button.fold").click();
  assert.equal(await row("incline/threshold").isVisible(), true);
  await row("incline/threshold").locator("td a").first().click();
  await page.locator(".view-cases").waitFor();
  assert.equal(await page.locator(".c-case a").count(), 3);
  assert.match(
    await page.evaluate(() => location.hash),
    /family=incline\/threshold&configuration=/,
  );
  unfaulted(page);
});

test("a word's meaning shows on focus and the list of words stands under About", async () => {
  const page = await browser.open(file);
  const word = page.locator(".totals .term").first();
  await word.focus();
  assert.match(await page.locator(".tip").innerText(), /at most its tolerance/);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".tip").isVisible(), false);
  await page.locator("a.words").click();
  await page.getByText("Tangential velocity of the two surfaces").waitFor();
  unfaulted(page);
});

test("the search finds a record by any quantity that it checks, draws or gives as a figure", async () => {
  const page = await browser.open(file, { hash: "#cases&q=kinetic energy" });
  assert.deepEqual(
    [...new Set(await page.locator(".c-case a").allInnerTexts())],
    ["incline/stop/mu=0.3"],
  );
});

test("plots have their data as a table and can be saved", async () => {
  const page = await browser.open(file, { hash: "#family=incline/threshold" });
  await draw_plots(page);
  await page.locator(".plot-data summary").first().click();
  await page.locator(".plot-data tbody tr").nth(2).waitFor();
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save SVG" }).first().click(),
  ]);
  assert.equal(download.suggestedFilename(), "plot.svg");
  unfaulted(page);
});

test("light and dark follow the system and the button; plots are drawn anew", async () => {
  const page = await browser.open(file, { dark: true });
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const ink = () => page.locator(".plot-canvas text").first().getAttribute("fill");
  await draw_plots(page);
  const dark = [await background(), await ink()];
  await page.getByRole("button", { name: "Light" }).click();
  await page.waitForFunction(
    (before) => document.querySelector(".plot-canvas text")?.getAttribute("fill") !== before,
    dark[1],
  );
  assert.notEqual(await background(), dark[0]);
  unfaulted(page);
});

test("nothing hangs over the edge at 400 px", async () => {
  const page = await browser.open(file, { width: 400, height: 800 });
  for (const hash of [
    "#summary",
    "#cases",
    "#case=incline/stop/mu=0.3",
    "#family=incline/threshold",
    "#plots",
    "#about",
  ]) {
    await turn_to(page, hash);
    await draw_plots(page);
    assert.ok(
      (await wide_overflow(page)) <= 0,
      `${hash} is ${await wide_overflow(page)} px too wide`,
    );
  }
  unfaulted(page);
});

test("on paper it is light and holds all rows", async () => {
  const records = Array.from({ length: 400 }, (_, i) => record({ case: `many/${i}` }));
  const page = await browser.open(make_page(make_run(lines_of(records))), {
    hash: "#cases",
    dark: true,
  });
  assert.ok((await page.locator(".c-case a").count()) < 100);
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await page.locator(".c-case a").count(), 400);
  assert.equal(await page.locator(".views").isVisible(), false);
  assert.equal(
    await page.evaluate(() => getComputedStyle(document.body).backgroundColor),
    "rgb(255, 255, 255)",
  );
  const pdf = await page.pdf();
  assert.ok(pdf.length > 10_000);
});

test("a damaged page says so", async () => {
  const damaged = file.replace(/\.html$/, "-damaged.html");
  writeFileSync(
    damaged,
    readFileSync(file, "utf8").replace(
      /<script type="text\/plain" data-asset="index"[^]*?<\/script>/,
      "",
    ),
  );
  const page = await browser.open(damaged, { wait: false });
  await page.getByText("This report cannot be shown").waitFor();
  assert.match(await page.locator("main").innerText(), /damaged or cut off/);
});
