// SPDX-License-Identifier: GPL-3.0-or-later
// The view of stability in a browser.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axe_source, draw_plots, start_browser, turn_to } from "./browser.mjs";
import { HOSTILE, lines_of, make_run, record, varied_records } from "./records.mjs";
import { make_page } from "./report.mjs";
import { perturbed, rung, stability_records, survived } from "./stability_records.mjs";

let browser;
let file;
before(async () => {
  browser = await start_browser({ webgl: false });
  file = make_page(make_run(lines_of(stability_records())));
});
after(() => browser.close());

const overflow = (page) =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

for (const [look, options] of Object.entries({
  light: {},
  dark: { dark: true },
  narrow: { width: 390 },
})) {
  test(`the view stands, draws and is accessible: ${look}`, async () => {
    const page = await browser.open(file, { ...options, hash: "#stability" });
    assert.match(
      await page.locator(".subline").innerText(),
      /3 of 6 perturbed cases keep their digits; 1 of 6 ladders holds on every rung; each of 3/,
    );
    const marks = await draw_plots(page);
    assert.equal(marks.length, 3);
    for (const one of marks) assert.ok(one > 1);
    assert.ok((await overflow(page)) <= 0);
    await page.evaluate(axe_source);
    const { violations } = await page.evaluate(() =>
      globalThis.axe.run(document, { resultTypes: ["violations"] }),
    );
    assert.deepEqual(
      violations
        .filter(({ impact }) => ["serious", "critical"].includes(impact))
        .map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 200)} ${nodes[0].failureSummary}`),
      [],
    );
    assert.deepEqual(page.faults, []);
    await page.context().close();
  });
}

test("the table tells digits, verdicts, why not, and leads to the check", async () => {
  const page = await browser.open(file);
  await page.getByRole("link", { name: "Stability", exact: true }).first().click();
  const table = page.locator(".of-one:not(.unchosen) table.digits-table");
  await table.waitFor();
  assert.deepEqual(await table.locator("thead th").allInnerTexts(), [
    "Case",
    "rerun",
    "turned",
    "bodies renumbered",
    "other units",
  ]);
  const rows = table.locator("tbody tr");
  assert.match(
    await rows.first().innerText(),
    /fall\s+holds\s+exact\s+holds\s+14\.6\s+n\/a\s+holds\s+exact/,
  );
  assert.match(await rows.nth(1).innerText(), /fails\s+6\.5\s+fails\s+–\s+holds\s+12\.3/);
  assert.match(await table.locator("tfoot").innerText(), /Fewest\s+exact\s+6\.5\s+–\s+12\.3/);
  assert.match(await rows.first().locator("td.lacks").getAttribute("title"), /too few bodies/);
  const cell = rows.nth(1).locator("td a").nth(1);
  assert.match(
    await cell.getAttribute("title"),
    /turned: fails, 6\.5 digits; σ\/scale 3e-07, allowed 1e-10\. Worst: height: 1 m, not 2, when turned/,
  );
  const commands = page.locator(".of-one:not(.unchosen) .points > .commands .command code");
  assert.deepEqual(await commands.allInnerTexts(), [
    "./stiction validate --case 'stack/rest/n=2' --perturb 'turned/2' --configuration 'quiet'",
    "./stiction validate --case 'stack/rest/n=2' --perturb 'bodies/2' --configuration 'quiet'",
  ]);
  await page.locator(".of-one:not(.unchosen) .points summary").click();
  await page.getByText("--case 'perturbed/fall'").first().waitFor();
  await cell.focus();
  await page.keyboard.press("ArrowRight");
  assert.match(
    await page.evaluate(() => document.activeElement.title),
    /^bodies renumbered: fails, no digit/,
  );
  await page.keyboard.press("Enter");
  await page.getByRole("heading", { level: 1, name: "perturbed/stack/rest/n=2" }).waitFor();
  const claim = page.locator(".claim.chosen");
  assert.match(await claim.innerText(), /^\s*bodies renumbered/);
  await page.waitForFunction(() => {
    const { top, bottom } = document.querySelector(".claim.chosen").getBoundingClientRect();
    return top >= 0 && bottom <= innerHeight;
  });
  await page.getByRole("link", { name: "Stability", exact: true }).last().click();
  await page.getByRole("heading", { level: 1, name: "Stability" }).waitFor();
  assert.deepEqual(page.faults, []);
});

test("a tab chooses the configuration; one that broke off says so", async () => {
  const page = await browser.open(file, { hash: "#stability" });
  await page.locator(".tabs a").filter({ hasText: "other · quick" }).click();
  const shown = page.locator(".of-one:not(.unchosen)");
  await shown.getByText("broke off: it exploded").waitFor();
  assert.match(await page.evaluate(() => location.hash), /^#stability&of=other/);
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator("table.digits-table:visible").count(), 3);
  assert.equal(await page.locator(".tabs").isVisible(), false);
});

test("a ladder names the last rung that holds and the first that does not, with its picture", async () => {
  const page = await browser.open(file, { hash: "#stability" });
  const overview = page.locator("table.ladders tbody tr");
  assert.match(await overview.first().innerText(), /mass-ratio\s+top\s+fails:\s+1 … 100, not 1000/);
  await overview.nth(1).getByRole("link").click();
  await page.waitForFunction(() => {
    const top = document.querySelector(".ladder.chosen")?.getBoundingClientRect().top;
    return top >= 0 && top < innerHeight / 2;
  });
  const first = page.locator(".ladder").first();
  await draw_plots(page);
  assert.match(
    await first.locator(".plot-canvas svg").textContent(),
    /quiet: holds 1 … 100, breaks at 1000/,
  );
  const row = first.locator("table.rungs tbody tr").first();
  assert.match(await row.innerText(), /100\s+1000\s+contact slip: 30 × its tolerance; box 3/);
  assert.equal(
    await row.locator("code").innerText(),
    "./stiction validate --case 'ladder/mass-ratio/top=1000' --configuration 'quiet'",
  );
  await row.getByRole("link", { name: "▶ picture" }).click();
  await page.getByRole("heading", { level: 1, name: "ladder/mass-ratio/top=1000" }).waitFor();
  await page.locator(".player").waitFor();
  assert.deepEqual(page.faults, []);
});

test("its cases are families as any, and the search knows the word", async () => {
  const page = await browser.open(file, { hash: "#cases&q=stability" });
  assert.match(await page.locator(".count-line").innerText(), /^\d+ records$/);
  await turn_to(page, "#summary");
  await page.locator(".stability-line a").waitFor();
  assert.match(await page.locator("table.answer").innerText(), /ladder\/mass-ratio/);
  await turn_to(page, "#family=ladder/touching");
  await page.locator(".plot-ladder svg").waitFor();
  await turn_to(page, "#plots=ladder");
  await page.locator(".plot-ladder svg").first().waitFor();
  assert.deepEqual(page.faults, []);
});

test("a run without such records has no such view", async () => {
  const page = await browser.open(make_page(make_run(lines_of(varied_records()))), {
    hash: "#stability",
  });
  await page.locator(".view-summary").waitFor();
  assert.equal(await page.getByText("Stability").count(), 0);
  assert.deepEqual(page.faults, []);
});

test("names are never markup, and hundreds of rungs are drawn", async () => {
  const hostile = { engine: HOSTILE, configuration: HOSTILE };
  const records = [
    perturbed(
      HOSTILE,
      [
        survived(HOSTILE, "inf", {
          worst: `${HOSTILE}, when the engine's arithmetic rounds ${HOSTILE}`,
        }),
      ],
      {
        ...hostile,
        notes: [`${HOSTILE}: not applicable: ${HOSTILE}`, "__proto__: not applicable: constructor"],
      },
    ),
    record({
      case: `ladder/${HOSTILE}/__proto__=3`,
      ...hostile,
      verdict: "error",
      error: HOSTILE,
      checks: [],
    }),
    record({ case: `ladder/x/${HOSTILE}`, ...hostile }),
    ...Array.from({ length: 400 }, (_, i) =>
      rung(
        `many/${i % 2 ? "constructor" : "__proto__"}=${(i - 50) * 10 ** ((i % 7) - 3)}`,
        i / 300,
        {
          configuration: i % 3 ? "constructor" : HOSTILE,
        },
      ),
    ),
  ];
  const page = await browser.open(make_page(make_run(lines_of(records))), { hash: "#stability" });
  await page.locator(".ladder").first().waitFor();
  for (const marks of await draw_plots(page)) assert.ok(marks > 0);
  assert.equal(await page.locator("main img").count(), 0);
  assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
  assert.ok((await overflow(page)) <= 0);
  assert.deepEqual(page.faults, []);
});
