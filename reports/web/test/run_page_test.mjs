// SPDX-License-Identifier: GPL-3.0-or-later
// What the page makes of runs: several, compared, cut off, short of a claim as known.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { draw_plots, start_browser, turn_to } from "./browser.mjs";
import { check, lines_of, make_run, old_check, old_record, record } from "./records.mjs";
import { make_page } from "./report.mjs";

let browser;
before(async () => {
  browser = await start_browser({ webgl: false });
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
  await turn_to(page, "#plots=trend");
  await page.locator(".plot-trend").first().waitFor();
  const marks = await draw_plots(page);
  assert.ok(marks.length >= 2 && marks.every((count) => count > 1));
  await turn_to(page, "#case=trend/a");
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
  await turn_to(page, "#summary");
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

test("what falls short as expected is told as such, with band and cause, and is no failure", async () => {
  const cause = "penalty contacts close the depth in steps";
  const band = { band: [0.3, 0.35] };
  const short = record({
    case: "limit/known",
    verdict: "expected-shortfall",
    checks: [check({ verdict: "expected-shortfall", cause, ...band, of_tolerance: 100 })],
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
  // A claim of the paper's, and a limit as version 2 wrote it.
  const refuted = record({
    ...short,
    case: "limit/refuted",
    verdict: "refuted",
    checks: [check({ verdict: "refuted", cause: "a scalar acts along the slip only", ...band })],
  });
  const old = old_record({
    schema_version: 2,
    case: "limit/old",
    verdict: "limit",
    checks: [old_check({ verdict: "limit", limit: "as version 2 said", error: 0.1 })],
  });
  const page = await browser.open(make_page(make_run(lines_of([short, refuted, old, record()]))));
  assert.equal(
    await page.locator("h1").innerText(),
    "Nothing fails: 1 holds, 2 fall short as expected, 1 refuted.",
  );
  assert.equal(await page.locator(".failures").count(), 0);
  assert.match(
    await page.locator(".facts").innerText(),
    /2 expected shortfalls, 1 refuted, 1 holds/,
  );
  await page.locator(".tally.verdict-refuted").click();
  await page.locator(".c-case a").click();
  await page.locator(".claim.verdict-refuted").waitFor();
  assert.match(await page.locator("main").innerText(), /a scalar acts along the slip only/);
  await page.goBack();
  await page.goBack();
  await page.locator(".tally.verdict-expected-shortfall").click();
  await page.locator(".c-case a", { hasText: "old" }).click();
  await page.locator(".claim.verdict-expected-shortfall").waitFor();
  assert.match(await page.locator("main").innerText(), /as version 2 said/);
  await page.goBack();
  await page.locator(".c-case a", { hasText: "known" }).click();
  await page.locator(".claim.verdict-expected-shortfall").waitFor();
  const text = await page.locator("main").innerText();
  assert.ok(text.includes(cause));
  assert.match(text, /as expected in \[0\.3, 0\.35\] m/);
  assert.match(
    text,
    /Mesh of box and 2 more: 1,234 vertices, 27 tetrahedra, dihedral angles 45\.0° to 90\.0°/,
  );
  unfaulted(page);
});

test("a value outside its band is a failure that says on which side", async () => {
  const outside = (name, value) =>
    record({
      schema_version: 3,
      case: `band/${name}`,
      verdict: "fail",
      checks: [
        check({
          verdict: "fail",
          value,
          error: value - 0.3,
          expected_low: 0.31,
          expected_high: 0.35,
          cause: "known",
        }),
      ],
    });
  const page = await browser.open(
    make_page(make_run(lines_of([outside("worse", 4e5), outside("better", 0.3000001)]))),
  );
  const text = await page.locator(".failures").innerText();
  assert.match(text, /worse than expected \[0\.31, 0\.35\] m/);
  assert.match(text, /better than known \[0\.31, 0\.35\] m: raise the bar/);
  unfaulted(page);
});
