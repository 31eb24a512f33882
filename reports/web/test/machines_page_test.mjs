// SPDX-License-Identifier: GPL-3.0-or-later
// Each table of CPU times names the machines where there are several; the page tells which these are, and hosts.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { figure } from "./compared_records.mjs";
import { start_browser, turn_to } from "./browser.mjs";
import { lines_of, make_run, record } from "./records.mjs";
import { make_page } from "./report.mjs";
import { on } from "./sweep_records.mjs";

let browser;
before(async () => (browser = await start_browser({ webgl: false })));
after(() => browser.close());

const text_of = async (page, selector) => (await page.locator(selector).allInnerTexts()).join("\n");
const NOTE =
  /Timings of 2 machines, which don't compare: A: Example CPU, 2 cores; B: Other CPU, 64 cores\./;
const mixed = () =>
  ["quiet", "old"].flatMap((configuration, i) =>
    [1, 2].map((k) =>
      record({
        case: `box/slope/mu=${k}`,
        configuration,
        ...on("ab"[i]),
        cost: { ...record().cost, cpu_seconds: 1 + k },
      }),
    ),
  );

test("tables of CPU time name the machines", async () => {
  const page = await browser.open(make_page(make_run(lines_of(mixed()))), { height: 1400 });
  assert.match(await text_of(page, ".machines-note"), NOTE);
  assert.match(await text_of(page, "table.answer"), /CPU time\s+5 s A\s+5 s B/);
  assert.match(await text_of(page, ".facts"), /CPU time\s+10 s[^]*A \+ B/);
  await turn_to(page, "#cases");
  const cells = await page.locator("td.c-seconds").allInnerTexts();
  assert.deepEqual(cells.map((text) => text.replace(/\s+/g, " ").trim()).sort(), [
    "2 A",
    "2 B",
    "3 A",
    "3 B",
  ]);
  assert.match(await text_of(page, ".machines-note"), NOTE);
  await turn_to(page, "#family=box/slope");
  assert.match(await text_of(page, "table.family-cases"), /4 A \+ B/);
  assert.match(await text_of(page, ".machines-note"), NOTE);
  await turn_to(page, "#case=box/slope/mu=1");
  assert.match(await text_of(page, "table.costs"), /2 A[^]*2 B/);
  assert.match(await text_of(page, ".machines-note"), NOTE);
  assert.deepEqual(page.faults, []);
});

test("with one machine there are no letters", async () => {
  const records = mixed().map((one) => ({ ...one, ...on("a") }));
  const page = await browser.open(make_page(make_run(lines_of(records))));
  for (const hash of [
    "#summary",
    "#cases",
    "#family=box/slope",
    "#case=box/slope/mu=1",
    "#about",
  ]) {
    await turn_to(page, hash);
    assert.equal(await page.locator(".machine, .machines-note").count(), 0, hash);
  }
});

test("a comparison's figures of CPU time name the machines", async () => {
  const records = ["secant", "none"].map((rule, i) =>
    record({
      case: "rules/stack",
      settings: { method: "quiet", rule },
      checks: [],
      figures: [figure("final creep", "m/s", 1e-6), figure("CPU time", "s", 1 + i)],
      ...on("ab"[i]),
    }),
  );
  const page = await browser.open(make_page(make_run(lines_of(records))));
  assert.match(await text_of(page, "table.winners"), /secant.* A/);
  assert.match(await text_of(page, "table.all-cases"), /A \+ B/);
  await turn_to(page, "#case=rules/stack");
  assert.match(await text_of(page, "table.compared"), /secant[^]* A/);
  assert.equal(
    await page.locator("table.compared td.best").count(),
    0,
    "no least over two machines",
  );
  assert.match(await text_of(page, ".machines-note"), NOTE);
});

test("two runs on different machines: the page says so", async () => {
  const before_run = make_run(lines_of(mixed().map((one) => ({ ...one, ...on("a") }))), "before");
  const page = await browser.open(make_page(make_run(lines_of(mixed())), "--against", before_run));
  await turn_to(page, "#compare");
  assert.match(await text_of(page, ".machines-note"), NOTE);
  assert.doesNotMatch(await text_of(page, ".subline"), /×/, "no ratio over two machines");
  await page.locator("details.unchanged summary").click();
  await page.locator("table.changes").waitFor();
  assert.match(await text_of(page, "table.changes"), /2 A\s+2 B/);
});

test("the page tells on which hosts how many records ran, and of old ones nothing", async () => {
  const hosts = [...mixed(), record({ case: "box/old", environment: record().environment })];
  const page = await browser.open(make_page(make_run(lines_of(hosts))));
  await turn_to(page, "#about");
  const rows = await page.locator("table.environments tbody tr").allInnerTexts();
  assert.equal(rows.length, 3);
  assert.match(rows[0], /A\s+Example CPU, 2 cores.*node-1: 2/s);
  assert.match(rows[1], /B\s+Other CPU, 64 cores.*node-2: 2/s);
  assert.match(rows[2], /C\s+a machine\s+g\+\+ 12\s+4f2a9c1\s+–\s+1/s);
  assert.deepEqual(page.faults, []);
});
