// SPDX-License-Identifier: GPL-3.0-or-later
// A case's page: the problem, what must hold, the results, how to run it again.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axe_source, start_browser } from "./browser.mjs";
import { clamp, incline } from "./problems.mjs";
import { check, HOSTILE, lines_of, make_run, record } from "./records.mjs";
import { make_page } from "./report.mjs";

const LONG = `the contacts come and go: ${"a long tale of why that is so, ".repeat(12)}`;
const CONFIGURATIONS = ["paper, secant", "quiet"];
const told = CONFIGURATIONS.map((configuration, i) =>
  record({
    case: "slope/case",
    configuration,
    settings: { dt: "0.001", method: configuration, ...(i === 1 && { kappa: "0.7" }) },
    differs: i === 1 ? { kappa: "0.7" } : {},
    simulations: 48,
    problem: incline(),
    verdict: i === 0 ? "refuted" : "pass",
    checks: [
      check({
        verdict: i === 0 ? "refuted" : "pass",
        of_tolerance: i === 0 ? 20 : 0.33,
        ...(i === 0 && {
          band: [0.2, 0.4],
          cause: `${LONG} (band: three times what was measured)`,
        }),
      }),
    ],
  }),
);
const hostile = record({ case: "hostile/case", problem: clamp() });
hostile.problem.bodies[0].name = HOSTILE;

let browser;
let file;
before(async () => {
  browser = await start_browser();
  file = make_page(make_run(lines_of([...told, hostile, record()])));
});
after(() => browser.close());

const open = async (name, options) => {
  const page = await browser.open(file, { hash: `#case=${name}`, ...options });
  await page.locator("#case-title").waitFor();
  return page;
};

test("the page says what the whole step cost, and how that spread", async () => {
  const page = await open("slope/case");
  const row = await page.locator("table.costs tbody tr").first().innerText();
  assert.match(row, /210 \(205 to 220\)\s+25 \(24 to 27\)/);
  assert.match(row, /0\.25\s+2\.5\s/); // CPU s, and of each of 0.1 simulated seconds
});

test("the page says what the problem is", async () => {
  const page = await open("slope/case");
  assert.equal(await page.locator("svg.sketch").count(), 1);
  const text = await page.locator(".problem").innerText();
  for (const wanted of [
    "box 0.2 × 0.2 × 0.1 m",
    "500 kPa",
    "μ = 0.5",
    "θ = 21.8°, tan θ = 0.4",
    "all at rest",
    "this is the first of 48 simulations",
    "turned so that gravity at its end points down",
  ])
    assert.ok(text.includes(wanted), wanted);
  assert.deepEqual(page.faults, []);
});

test("a record without a problem has no sketch, and nothing in its place", async () => {
  const page = await open("incline/stop/mu=0.3");
  assert.equal(await page.locator(".problem").count(), 0);
  assert.equal(await page.locator("svg.sketch").count(), 0);
  assert.deepEqual(page.faults, []);
});

test("results stand by configuration; settings in common are said once", async () => {
  const page = await open("slope/case");
  const rows = await page.locator("table.results tbody tr:not(.quantity)").allInnerTexts();
  assert.equal(rows.length, 2);
  assert.match(
    rows[0],
    /paper, secant\s+refuted\s+0\.3001\s+0\.3\s+0\.00033 rel\s+0\.001 rel\s+20 ×/,
  );
  assert.match(rows[1], /quiet\s+holds[^]*33 %/);
  const colours = await page
    .locator("table.results .style-mark")
    .evaluateAll((marks) => marks.map((mark) => mark.getAttribute("class")));
  assert.deepEqual(colours, ["style-mark series-s3", "style-mark series-s0"]);
  await page.locator(".settings summary").click();
  const settings = await page.locator(".settings").innerText();
  assert.match(settings, /Of all: dt = 0\.001/);
  assert.match(settings, /quiet\s+method = quiet, kappa = 0\.7/);
  assert.equal(settings.match(/dt = /g).length, 1);
});

test("a long cause is folded to its first words, and unfolds for paper", async () => {
  const page = await open("slope/case");
  const cause = page.locator("details.folded");
  assert.equal(await cause.locator("summary").innerText(), "the contacts come and go …");
  assert.equal(await cause.getByText("a long tale").isVisible(), false);
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await cause.getByText("a long tale").isVisible(), true);
  assert.match(await page.locator(".claim").innerText(), /Band\s+three times what was measured/);
});

test("the commands run it again, whole and by configuration", async () => {
  const page = await open("slope/case");
  assert.deepEqual(await page.locator(".command code").allInnerTexts(), [
    "./stiction validate --case 'slope/case'",
    "./stiction validate --case 'slope/case' --configuration 'paper, secant'",
    "./stiction validate --case 'slope/case' --configuration 'quiet' --set 'kappa=0.7'",
  ]);
  await page.getByRole("button", { name: /^Copy\s*: the case/ }).click();
  await page.getByRole("button", { name: /^(Copied|Selected)\s*: the case/ }).waitFor();
});

test("names of a problem stay text, at any width, in any theme", async () => {
  const page = await open("hostile/case", { width: 390, height: 800, dark: true });
  assert.match(await page.locator(".problem").innerText(), /<img src=x onerror=/);
  assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
  const wide = await page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  assert.ok(wide <= 0, `${wide} px too wide`);
  assert.deepEqual(page.faults, []);
});

test("axe finds nothing serious on a case's page", async () => {
  for (const dark of [false, true]) {
    const page = await open("slope/case", { dark });
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
  }
});
