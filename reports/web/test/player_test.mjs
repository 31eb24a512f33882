// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start_browser, turn_to } from "./browser.mjs";
import { check, lines_of, make_run, record, varied_records } from "./records.mjs";
import { make_page } from "./report.mjs";

const HASH = "#case=incline/stop/mu=0.3";
let browser;
let file;
before(async () => {
  browser = await start_browser();
  file = make_page(make_run(lines_of(varied_records())));
});
after(() => browser.close());

const loaded = (page) => page.locator(".player[data-loaded]").waitFor();
const first_x = (page) =>
  page
    .locator(".player")
    .evaluate((player) => player.stiction_positions().map((positions) => positions[0]));
const to_start = async (page) => {
  await page.locator(".player").focus();
  await page.keyboard.press("Home");
};
const frame = (page) => page.locator(".player").getAttribute("data-frame");

test("two runs of a case are shown side by side and move together", async () => {
  const page = await browser.open(file, { hash: HASH });
  await loaded(page);
  assert.deepEqual(await page.locator(".pane-label").allInnerTexts(), [
    "paper, fixed point",
    "paper, no memory",
  ]);
  await to_start(page);
  const start = await first_x(page);
  assert.equal(start.length, 2);
  assert.ok(Math.abs(start[0] + 0.1) < 1e-4);
  await page.locator(".player input[type=range]").fill("40");
  const end = await first_x(page);
  for (const x of end) assert.ok(Math.abs(x - 0.9) < 1e-4, `the box stands at ${x}`);
  assert.match(
    await page.locator(".contact-words").first().innerText(),
    /4 stick, 0 slip · 9\.8 N normal, 0 N friction/,
  );
  assert.deepEqual(page.faults, []);
});

test("something is drawn, and it changes with time", async () => {
  const page = await browser.open(file, { hash: HASH });
  await loaded(page);
  const canvas = page.locator(".pane canvas").first();
  const shot = () => canvas.screenshot();
  await to_start(page);
  const start = await shot();
  await page.locator(".player input[type=range]").fill("30");
  const end = await shot();
  assert.ok(start.length > 3000, "the picture is empty");
  assert.ok(!start.equals(end), "the picture stands still");
  await page.getByLabel("forces").uncheck();
  assert.ok(!(await shot()).equals(end), "the forces do not go");
});

test("it plays and pauses", async () => {
  const page = await browser.open(file, { hash: HASH });
  await loaded(page);
  await page.locator(".player select[aria-label=Speed]").selectOption("1");
  await to_start(page);
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForFunction(() => Number(document.querySelector(".player").dataset.frame) >= 2);
  await page.waitForFunction(() => document.querySelector(".player").dataset.frame === "40");
  assert.equal(await page.locator(".play").innerText(), "Play");
  await page.locator(".player select[aria-label=Speed]").selectOption("0.1");
  await page.locator(".play").click();
  await page.locator(".play").click();
  assert.equal(await page.locator(".play").innerText(), "Play");
});

test("keys play, step and jump", async () => {
  const page = await browser.open(file, { hash: HASH });
  await loaded(page);
  await to_start(page);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowLeft");
  assert.equal(await frame(page), "1");
  await page.keyboard.press("End");
  assert.equal(await frame(page), "40");
  await page.keyboard.press("Home");
  assert.equal(await frame(page), "0");
  await page.keyboard.press("Space");
  await page.waitForFunction(() => Number(document.querySelector(".player").dataset.frame) > 0);
  assert.equal(await page.locator("h1").innerText(), "incline/stop/mu=0.3");
});

test("turning one camera turns the other", async () => {
  const page = await browser.open(file, { hash: HASH });
  await loaded(page);
  const other = page.locator(".pane canvas").nth(1);
  const start = await other.screenshot();
  const box = await page.locator(".pane canvas").first().boundingBox();
  await page.mouse.move(box.x + 100, box.y + 80);
  await page.mouse.down();
  await page.mouse.move(box.x + 160, box.y + 100, { steps: 4 });
  await page.mouse.up();
  await page.waitForTimeout(100);
  assert.ok(!(await other.screenshot()).equals(start));
});

test("of three recordings two are chosen", async () => {
  const rules = ["none", "fixed-point", "secant"];
  const run = make_run(
    lines_of(rules.map((rule) => record({ settings: { rule }, frames: "frames/box.bin" }))),
  );
  const page = await browser.open(make_page(run), { hash: HASH });
  await loaded(page);
  await page.locator("select[data-side=right]").selectOption("2");
  await page.waitForFunction(
    () => document.querySelectorAll(".pane-label")[1]?.textContent.trim() === "paper, secant",
  );
  assert.deepEqual(page.faults, []);
});

test("without WebGL it says so, draws flat, and time still runs", async () => {
  const plain = await start_browser({ webgl: false });
  try {
    const page = await plain.open(file, { hash: HASH });
    await loaded(page);
    assert.match(await page.locator(".player .message").innerText(), /gives no WebGL/);
    const shape = () => page.locator(".still polygon:not(.ground)").first().getAttribute("points");
    await to_start(page);
    const start = await shape();
    await page.locator(".player input[type=range]").fill("40");
    assert.notEqual(await shape(), start);
    assert.match(await page.locator(".contact-words").first().innerText(), /4 stick/);
    assert.deepEqual(page.faults, []);
  } finally {
    await plain.close();
  }
});

test("on paper the scene is drawn", async () => {
  const page = await browser.open(file, { hash: HASH });
  await loaded(page);
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await page.locator(".paper .still").first().isVisible(), true);
  assert.equal(await page.locator(".pane canvas").first().isVisible(), false);
});

test("a page without recordings carries no player", async () => {
  const page = await browser.open(make_page(make_run(lines_of([record()]))), { hash: HASH });
  assert.equal(await page.locator(".player").count(), 0);
  assert.equal(await page.locator('[data-asset="code/player"]').count(), 0);
});

test("players that were left give back what they held; the theme reaches the scene", async () => {
  const page = await browser.open(file, { hash: HASH, width: 420, height: 500 });
  for (let i = 0; i < 9; ++i) {
    await loaded(page);
    await turn_to(page, "#case=clamp/hold");
    await page.getByRole("heading", { level: 1, name: "clamp/hold" }).waitFor();
    await turn_to(page, HASH);
  }
  await loaded(page);
  await page.locator(".player input[type=range]").fill("20");
  const light = await page.locator(".pane canvas").first().screenshot();
  await page.getByRole("button", { name: "Dark" }).click();
  await page.waitForFunction(() => document.querySelector(".player canvas").width > 0);
  assert.equal(await frame(page), "20");
  assert.ok(!light.equals(await page.locator(".pane canvas").first().screenshot()));
  assert.deepEqual(page.faults, []);
});

test("displacements are drawn larger, from a moment that can be chosen, and the picture says so", async () => {
  const page = await browser.open(file, { hash: HASH });
  await loaded(page);
  const slider = page.locator(".player input[type=range]");
  await slider.fill("20");
  const plain = (await first_x(page))[0];
  const words = page.locator(".scale-words").first();
  assert.equal(await words.isVisible(), false);
  await page.getByLabel("Displacements drawn larger").selectOption("10");
  const start = -0.1; // where the box stands in the first frame
  const drawn = (await first_x(page))[0];
  assert.ok(Math.abs(drawn - (start + 10 * (plain - start))) < 1e-3, `${drawn}`);
  assert.match(await words.innerText(), /displacements × 10 since 0 s; recorded to \S+ m/);
  await page.getByRole("button", { name: "from here" }).click();
  assert.ok(Math.abs((await first_x(page))[0] - plain) < 1e-4, "it has not moved from itself");
  assert.doesNotMatch(await words.innerText(), /since 0 s/);
  assert.deepEqual(page.faults, []);
});

test("it opens on the telling pair at the telling moment", async () => {
  const verdicts = ["pass", "expected-shortfall", "pass"];
  const rules = ["none", "secant", "fixed-point"];
  const run = make_run(
    lines_of(
      rules.map((rule, i) =>
        record({
          settings: { rule },
          verdict: verdicts[i],
          checks: [check({ verdict: verdicts[i], of_tolerance: [0.9, 7, 0.1][i] })],
          frames: "frames/box.bin",
        }),
      ),
    ),
  );
  const page = await browser.open(make_page(run), { hash: HASH });
  await loaded(page);
  assert.deepEqual(
    (await page.locator(".pane-label").allInnerTexts()).map((text) => text.trim()),
    ["paper, secant", "paper, fixed point"],
  );
  assert.notEqual(await frame(page), "0");
});
