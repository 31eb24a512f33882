// SPDX-License-Identifier: GPL-3.0-or-later
// The verification manual: every case, whole, without scripts.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { spawnSync } from "node:child_process";
import { after, before, test } from "node:test";
import { parse_arguments } from "../make/arguments.mjs";
import { pages_of } from "../make/manual_pages.mjs";
import { axe_source, start_browser } from "./browser.mjs";
import { clamp, incline } from "./problems.mjs";
import {
  HOSTILE,
  hostile_records,
  lines_of,
  make_run,
  record,
  varied_records,
} from "./records.mjs";
import { build, report } from "./report.mjs";
import { temporary_folder } from "./temporary.mjs";

let browser;
before(async () => (browser = await start_browser({ webgl: false })));
after(() => browser.close());

const told = (change = {}) =>
  record({
    configuration: "quiet",
    differs: {},
    simulations: 48,
    problem: incline(),
    ...change,
  });

function make_manual(records, ...words) {
  const file = join(temporary_folder(), "manual.html");
  const run = make_run(lines_of(records));
  const { status, err } = report(run, "--manual", file, ...words);
  assert.equal(status, 0, err);
  return file;
}

const open = (file, options) => browser.open(file, { ...options, wait: false });

test("the manual has every case of a run, linked from its contents", async () => {
  const records = [
    ...varied_records(),
    told({ case: "with/problem" }),
    told({ case: "clamp/held", problem: clamp() }),
  ];
  const page = await open(make_manual(records));
  const text = await page.locator("main").innerText();
  for (const { case: name } of records)
    if (!name.startsWith("incline/threshold")) assert.ok(text.includes(name), name);
  assert.match(text, /incline\/threshold\/mu=\* \(3 cases\)/);
  for (const mu of [0.1, 0.3, 0.5]) assert.ok(text.includes(`mu=${mu}: `), `μ = ${mu}`);
  const broken = await page.evaluate(() =>
    [...document.querySelectorAll("a[href]")]
      .map((link) => link.getAttribute("href"))
      .filter((href) => !href.startsWith("#") || !document.getElementById(href.slice(1))),
  );
  assert.deepEqual(broken, []);
  const twice = await page.evaluate(() => {
    const ids = [...document.querySelectorAll("[id]")].map(({ id }) => id);
    return ids.filter((id, i) => ids.indexOf(id) !== i);
  });
  assert.deepEqual(twice, []);
  assert.equal(await page.locator("script").count(), 0);
  assert.deepEqual(page.faults, []);
});

test("a page has the drawing, the data, the claim, the result, the plot, the hash and the command", async () => {
  const series = [
    { name: "velocity", unit: "m/s", x_name: "time", x_unit: "s", x: [0, 1, 2], y: [1, 0.5, 0] },
  ];
  const page = await open(make_manual([told({ case: "one/case", series, notes: ["a note"] })]));
  const leaf = page.locator("#case-1");
  const text = await leaf.innerText();
  for (const wanted of [
    "one/case",
    "a box stops",
    "box 0.2 × 0.2 × 0.1 m",
    "tan θ = 0.4",
    "the first of 48 simulations",
    "a sliding box stops",
    "d = v₀²/(2μg)",
    "0.3 m: Coulomb's law (closed form)",
    "0.001 rel: half a step of travel",
    "0.3001",
    "33 %",
    "quiet",
    "a note",
    "0123456789abcdef",
    "./stiction validate --case 'one/case'",
  ])
    assert.ok(text.includes(wanted), wanted);
  assert.equal(await leaf.locator("svg.sketch").count(), 1);
  assert.ok(await leaf.locator(".plot img").evaluate((image) => image.naturalWidth > 100));
  assert.deepEqual(page.faults, []);
});

test("a record without a problem says so, one that broke off why", async () => {
  const page = await open(
    make_manual([
      record({ case: "old/case" }),
      record({ case: "z", verdict: "error", error: "it burst", checks: [] }),
    ]),
  );
  assert.match(await page.locator("#case-1").innerText(), /does not tell the problem/);
  assert.equal(await page.locator("svg.sketch").count(), 0);
  assert.match(await page.locator("#case-2").innerText(), /broke off: it burst/);
});

test("hostile text stays text", async () => {
  const problem = incline();
  problem.bodies[0].name = HOSTILE;
  problem.obstacles[0].name = HOSTILE;
  const records = [...hostile_records(), told({ case: HOSTILE, problem })];
  const page = await open(make_manual(records, "--title", HOSTILE));
  assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
  assert.equal(await page.locator("script").count(), 0);
  assert.equal(await page.locator('img[src="x"]').count(), 0);
  assert.match(await page.locator("main").innerText(), /<img src=x onerror=/);
  assert.deepEqual(page.faults, []);
});

test("it is readable: axe finds nothing serious, and nothing hangs over at 390 px", async () => {
  const records = [...varied_records(), told({ case: "with/problem" })];
  const page = await open(make_manual(records), { width: 390, height: 800 });
  const wide = await page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  assert.ok(wide <= 0, `${wide} px too wide`);
  await page.evaluate(axe_source);
  const { violations } = await page.evaluate(() =>
    globalThis.axe.run(document, { resultTypes: ["violations"] }),
  );
  assert.deepEqual(
    violations
      .filter(({ impact }) => ["serious", "critical"].includes(impact))
      .map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 160)}`),
    [],
  );
});

test("on paper each case begins a page", async () => {
  const page = await open(make_manual([told({ case: "a" }), told({ case: "b" })]));
  const pages = (await page.pdf({ preferCSSPageSize: true }))
    .toString("latin1")
    .match(/\/Type\s*\/Page\b/g);
  assert.equal(pages.length, 5, "title, contents, reading, two cases");
});

test("a PDF where Chromium is, else one sentence and exit code 2", () => {
  const run = make_run(lines_of([told()]));
  const file = join(temporary_folder(), "manual.pdf");
  const made = report(run, "--manual", file);
  assert.equal(made.status, 0, made.err);
  assert.equal(readFileSync(file).subarray(0, 5).toString(), "%PDF-");
  const none = spawnSync(
    process.execPath,
    [join(build, "report.mjs"), run, "--manual", `${file}-2.pdf`],
    {
      encoding: "utf8",
      env: { ...process.env, PATH: "/nowhere", CHROMIUM: "" },
    },
  );
  assert.equal(none.status, 2);
  assert.match(none.stderr, /^stiction report: a PDF needs Chromium[^\n]*\n$/);
  assert.equal(existsSync(`${file}-2.pdf`), false);
});

test("the file may be left out; another kind of file is refused", () => {
  assert.equal(parse_arguments(["run", "--manual"]).manual, "");
  assert.deepEqual(parse_arguments(["--manual", "run"]).folders, ["run"]);
  assert.equal(parse_arguments(["run", "--manual", "x.pdf"]).manual, "x.pdf");
  assert.equal(parse_arguments(["run"]).manual, undefined);
  assert.throws(() => parse_arguments(["run", "--manual=x.doc"]), /not 'x\.doc'/);
  const run = make_run(lines_of([told()]));
  const { status, out } = report(run, "--manual");
  assert.equal(status, 0);
  assert.match(out, /verification-manual\.html/);
  assert.ok(existsSync(join(run, "verification-manual.html")));
});

test("cases that differ in parameters alone share a page from three on", () => {
  const entries = ["f/mu=1", "f/mu=2", "g/a=1", "f/mu=3", "g/a=2", "h/50%", "h/60%", "h/70%"].map(
    (name) => ({ record: record({ case: name }), run: 0 }),
  );
  assert.deepEqual(
    pages_of(entries).map(({ name, cases }) => [name, cases.length]),
    [
      ["f/mu=*", 3],
      ["g/a=1", 1],
      ["g/a=2", 1],
      ["h/*", 3],
    ],
  );
});
