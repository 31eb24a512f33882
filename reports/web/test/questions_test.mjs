// SPDX-License-Identifier: GPL-3.0-or-later
// Questions that people come with, each answered on the first screen or within two clicks, as a person clicks:
// by the words that stand there. Of a run of `./stiction validate` ($STICTION_TEST_RUN, as .ci/run names it), the
// one about engines of records made for tests.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start_browser, turned } from "./browser.mjs";
import { engine_records } from "./engine_records.mjs";
import { lines_of, make_run } from "./records.mjs";
import { make_page } from "./report.mjs";

const run = process.env.STICTION_TEST_RUN;
const skip = run ? false : "$STICTION_TEST_RUN names no run";
const MOST_CLICKS = 2;

const on = (selector, text) => (page) => page.locator(selector).filter({ hasText: text }).first();
const link = (name) => (page) => page.getByRole("link", { name, exact: true }).first();

// {question, clicks: what is clicked, in order, where the answer then stands, and what it says}.
const QUESTIONS = [
  {
    question: "Does anything fail?",
    clicks: [],
    where: on("h1", ""),
    answer: /^(Nothing fails: \d+ hold|\d+ fails?,)/,
  },
  {
    question: "Who creeps, and how fast?",
    clicks: [],
    where: on("tr", "Creeps at rest"),
    answer: /Creeps at rest\s+(no, 0|yes, [1-9]\d*) of \d+[\s\S]*yes, \d+ of \d+\s+≤ \S+ m\/s/,
  },
  {
    question: "Does quiet hold flush stacks?",
    clicks: [on("summary, button", "other families")],
    where: on("tr", /^stack\/flush/),
    answer: /stack\/flush\s+holds\s+\d+/,
  },
  {
    question: "Why does the paper's method fall short here (the pushed box on the slab)?",
    clicks: [on("main a", /^push-and-retract\/slab\/\d+%$/)],
    where: on("main", "What must hold"),
    answer: /Cause\s+the scalar ξ: it holds friction only against a slip that goes on/,
  },
  {
    question: "How do I rerun this?",
    clicks: [on("main a", /^push-and-retract\/slab\/\d+%$/)],
    where: on(".command", "./stiction validate"),
    answer: /\.\/stiction validate --case 'push-and-retract\/slab\/\d+%'/,
  },
  {
    question: "What is the problem: which bodies, of which size, mass and friction?",
    clicks: [on("main a", /^slab\/rest\/(one|fixed|random)$/)],
    where: on("main", "The problem"),
    answer: /box\s+box 0\.1 × 0\.1 × 0\.1 m[\s\S]*μ = 0\.5/,
  },
  {
    question: "What does 'refuted' mean?",
    clicks: [link("what these words mean")],
    where: on("main", "refuted"),
    answer: /refuted\s+[\s\S]{0,40}claim/i,
  },
  {
    question: "How accurately is the critical slope met?",
    clicks: [on("summary, button", "other families"), link("incline/threshold")],
    where: on(".view-family", "Measured against expected"),
    answer: /Measured against expected[\s\S]*holds\s+mu=0\.1\/azimuth=0\/yaw=0/,
  },
  {
    question: "Does a smaller step help?",
    clicks: [link("slab/effort"), on("main tbody a", "slab/effort")],
    where: on("main", "Results by configuration"),
    answer:
      /paper, fixed point · dt=5e-05\s+refuted\s+2\.\d+e-05[\s\S]*quiet · dt=5e-05\s+holds\s+0\s/,
  },
  {
    question: "Which revision, on which machine?",
    clicks: [],
    where: on(".provenance", ""),
    answer: /revision [0-9a-f]{6,}.* · GCC .* cores?/,
  },
  {
    question: "What does it look like?",
    clicks: [on(".play-line a", "paper/fig5-box-pyramid")],
    where: on(".player[data-loaded]", "Play"),
    answer: /\d+ stick, \d+ slip · \S+ N normal/,
  },
];

let browser;
let file;
before(async () => {
  browser = await start_browser({ webgl: false });
  if (!skip) file = make_page(run);
});
after(() => browser?.close());

for (const { question, clicks, where, answer } of QUESTIONS) {
  test(`${question} (${clicks.length} clicks)`, { skip }, async () => {
    assert.ok(clicks.length <= MOST_CLICKS);
    const page = await browser.open(file);
    for (const target of clicks) {
      await target(page).click({ timeout: 10_000 });
      await turned(page);
    }
    const place = where(page);
    await place.waitFor({ timeout: 10_000 });
    assert.match(await place.innerText(), answer);
    // What needs no click stands on the first screen.
    if (clicks.length === 0) assert.ok((await place.boundingBox()).y < 900);
    await page.context().close();
  });
}

test("What does an error of 1e-6 cost? (0 clicks, on the page of engines)", async () => {
  const page = await browser.open(make_page(make_run(lines_of(engine_records()))));
  const text = await page.locator("table.cheapest").innerText();
  assert.match(text, /1e-6|1e-06/);
  assert.match(text, /ms/);
  await page.context().close();
});
