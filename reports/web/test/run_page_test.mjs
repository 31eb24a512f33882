// SPDX-License-Identifier: GPL-3.0-or-later
// What the page makes of runs: several, compared, cut off, short of a claim as known.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { draw_plots, start_browser } from "./browser.mjs";
import { check, lines_of, make_run, record } from "./records.mjs";
import { make_page } from "./report.mjs";

let browser;
before(async () => {
  browser = await start_browser();
});
after(() => browser.close());

const unfaulted = (page) => assert.deepEqual(page.faults, []);

test("several runs are merged: runs are named, history is drawn", async () => {
  const run = (day, seconds) =>
    make_run(
      lines_of(
        ["a", "b"].map((name) =>
          record({
            case: `trend/${name}`,
            environment: { ...record().environment, date: `2025-11-${day}T00:00:00Z` },
            cost: { ...record().cost, cpu_seconds: seconds },
          }),
        ),
      ),
      `day-${day}`,
    );
  const page = await browser.open(make_page(run("20", 1), run("21", 2), run("22", 1.5)), {
    hash: "#family=trend/a",
  });
  await page.evaluate(() => (location.hash = "#plots=trend"));
  await page.locator(".plot-trend").first().waitFor();
  const marks = await draw_plots(page);
  assert.ok(marks.length >= 2 && marks.every((count) => count > 1));
  await page.evaluate(() => (location.hash = "#case=trend/a"));
  await page.locator(".costs").waitFor();
  assert.match(await page.locator(".costs").innerText(), /day-20[^]*day-21[^]*day-22/);
  unfaulted(page);
});

test("two runs are compared", async () => {
  const before_run = make_run(
    lines_of([record({ case: "a" }), record({ case: "b" }), record({ case: "c" })]),
    "before",
  );
  const after_run = make_run(
    lines_of([
      record({
        case: "a",
        verdict: "fail",
        checks: [check({ verdict: "fail", error: 0.01, digits: 2 })],
      }),
      record({
        case: "b",
        cost: { ...record().cost, cpu_seconds: 0.5 },
        checks: [check({ digits: 4.5 })],
      }),
      record({ case: "d" }),
    ]),
    "after",
  );
  const page = await browser.open(make_page(after_run, "--against", before_run), {
    hash: "#compare",
  });
  assert.match(await page.locator("h1").innerText(), /1 verdict became worse/);
  const text = await page.locator(".changes").innerText();
  assert.match(text, /verdict worse[^]*gone[^]*more digits[^]*new/);
  assert.match(text, /\+1\.0[^]*× 2/);
  const marks = await draw_plots(page);
  assert.equal(marks.length, 2);
  await page.evaluate(() => (location.hash = "#summary"));
  await page.locator(".change-line").waitFor();
  assert.match(await page.locator(".change-line").innerText(), /1 verdict worse/);
  assert.match(await page.locator(".subline").innerText(), /3 records of 3 cases/);
  unfaulted(page);
});

test("warnings stand on top, licences in the page", async () => {
  const page = await browser.open(make_page(make_run(lines_of([record()]) + '{"cut')), {
    hash: "#about",
  });
  assert.match(await page.locator(".warnings").innerText(), /was cut off/);
  const licences = await page.locator(".licences summary").allInnerTexts();
  for (const name of ["vega ", "vega-lite ", "three ", "d3-scale "])
    assert.ok(
      licences.some((text) => text.startsWith(name)),
      name,
    );
  assert.ok(
    (await page.locator(".licences pre").allTextContents()).filter((text) => text.length > 200)
      .length > 20,
  );
  unfaulted(page);
});

test("a known limit is told as such, with its reason, and is no failure", async () => {
  const limit = "penalty contacts close the depth in steps";
  const short = record({
    schema_version: 2,
    case: "limit/known",
    verdict: "limit",
    checks: [check({ verdict: "limit", limit, error: 0.1 })],
    meshes: [
      {
        bodies: "box and 2 more",
        vertices: 1234,
        tetrahedra: 27,
        min_dihedral_angle: 45,
        max_dihedral_angle: 90,
        min_altitude: 0.05,
      },
    ],
  });
  const page = await browser.open(make_page(make_run(lines_of([short, record()]))));
  assert.equal(await page.locator("h1").innerText(), "1 holds, 1 falls short as known.");
  assert.equal(await page.locator(".failures").count(), 0);
  assert.match(await page.locator(".facts").innerText(), /1 known limit, 1 holds/);
  await page.locator(".tally.verdict-limit").click();
  await page.locator(".c-case a").click();
  await page.locator(".claim.verdict-limit").waitFor();
  const text = await page.locator("main").innerText();
  assert.ok(text.includes(limit));
  assert.match(
    text,
    /Mesh of box and 2 more: 1,234 vertices, 27 tetrahedra, dihedral angles 45\.0° to 90\.0°/,
  );
  unfaulted(page);
});
