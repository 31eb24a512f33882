// SPDX-License-Identifier: GPL-3.0-or-later
// A hundred thousand records stay usable.
import assert from "node:assert/strict";
import { closeSync, openSync, rmSync, statSync, writeSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { draw_plots, open_within, start_browser, time_of } from "./browser.mjs";
import { check, make_run, record } from "./records.mjs";
import { make_page } from "./report.mjs";

const COUNT = 100_000;
let browser;
let file;
before(async () => {
  browser = await start_browser({ webgl: false });
  const folder = make_run("");
  const out = openSync(join(folder, "records.jsonl"), "w");
  for (let i = 0; i < COUNT; i += 1000) {
    let text = "";
    for (let k = i; k < i + 1000; ++k) {
      const fails = k % 997 === 0;
      const error = (k % 89) * (fails ? 1e-3 : 1.1e-5);
      const verdict = fails && error > 1e-3 ? "fail" : "pass";
      text += `${JSON.stringify(record({ case: `sweep-${k % 40}/threshold/mu=${(k % 1000) / 1000}/seed=${k}`, verdict, checks: [check({ value: 0.3 + error, error, digits: 16 - (k % 14), verdict })] }))}\n`;
    }
    writeSync(out, text);
  }
  closeSync(out);
  file = make_page(folder);
  rmSync(join(folder, "records.jsonl"));
});
after(() => browser.close());

test("a hundred thousand records are ready in two seconds, in a page below 15 MB", async () => {
  assert.ok(statSync(file).size < 15e6, `${statSync(file).size} bytes`);
  const page = await open_within(browser, file, 2000);
  console.log(page.told);
  assert.ok(page.in_time, page.told);
  assert.ok((await draw_plots(page))[0] > 10);
  assert.deepEqual(page.faults, []);
});

test("they are searched, sorted and scrolled within a second each", async () => {
  const page = await browser.open(file, { hash: "#cases" });
  const within = async (name, act) => {
    const taken = await time_of(browser, page, act);
    assert.ok(taken.ms < 1000, `${name} took ${taken.told}`);
  };
  assert.ok((await page.locator(".c-case a").count()) < 100);
  await within("searching", async () => {
    await page.locator("#search").fill("seed=77777");
    await page.waitForFunction(() => document.querySelectorAll(".c-case a").length === 1);
  });
  await page.getByRole("button", { name: "Clear" }).click();
  await page.waitForFunction(() => document.querySelectorAll(".c-case a").length > 10);
  await within("sorting", async () => {
    await page.getByRole("button", { name: "Digits" }).click();
    await page.waitForFunction(() => document.querySelector("td.c-digits").textContent === "3.0");
  });
  await within("scrolling to the end", async () => {
    await page
      .locator(".table-scroll")
      .evaluate((element) => (element.scrollTop = element.scrollHeight));
    await page.waitForFunction(
      (count) => document.querySelector(`tr[aria-rowindex="${count + 1}"]`) !== null,
      COUNT,
    );
  });
  await page.locator(".c-case a").last().click();
  await page.locator(".claim").waitFor();
  assert.deepEqual(page.faults, []);
});
