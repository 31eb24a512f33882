// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps on the page, in a real browser.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { PALETTES } from "../plots/palette.js";
import { draw_plots, start_browser, turn_to } from "./browser.mjs";
import { HOSTILE, lines_of, make_run } from "./records.mjs";
import { make_page, report } from "./report.mjs";
import { grid, measured, point, runs, steps } from "./sweep_records.mjs";
import { temporary_folder } from "./temporary.mjs";

let browser;
before(async () => (browser = await start_browser({ webgl: false })));
after(() => browser.close());

const page_of = (records) => make_page(make_run(lines_of(records)));

for (const [name, records] of Object.entries(runs()))
  test(`its pictures are drawn within the page's width, light and dark: ${name}`, async () => {
    const file = page_of(records);
    for (const options of [{ width: 1400 }, { width: 390, dark: true }]) {
      const page = await browser.open(file, { ...options, hash: "#family=user/box" });
      await page.locator(".plot").first().waitFor();
      const marks = await draw_plots(page);
      assert.ok(marks.length >= 3, `${marks.length} plots`);
      const wide = await page
        .locator(".plot-canvas")
        .evaluateAll((plots) =>
          plots
            .map((plot) => [
              plot.clientWidth,
              Number(plot.querySelector("svg, canvas").getAttribute("width")),
            ])
            .filter(([room, width]) => width > room + 1),
        );
      assert.deepEqual(wide, [], JSON.stringify(options));
      assert.equal(await page.getByText("cannot be drawn").count(), 0);
      assert.deepEqual(page.faults, []);
      await page.context().close();
    }
  });

test("the summary shows who holds, the page of the family all; a mark opens its point", async () => {
  const page = await browser.open(page_of(runs().two));
  await page.locator(".plot-phase-diagram").waitFor();
  assert.equal(await page.locator(".plot-heat-map, .plot-sweep-cost").count(), 0);
  await turn_to(page, "#plots=heat-map");
  await page.locator(".plot-heat-map").first().waitFor();
  await draw_plots(page);
  const kinds = await page.locator(".tabs a").allInnerTexts();
  assert.deepEqual(kinds.slice(0, 3), ["Sweeps", "Measured over sweeps", "Cost of sweeps"]);
  await page.locator(".plot-heat-map details summary").first().click();
  await page.locator(".plot-heat-map table.data").waitFor();
  const heads = await page.locator(".plot-heat-map table.data th").allInnerTexts();
  for (const head of ["case", "ramp.friction", "ramp.slope_deg (°)"])
    assert.ok(heads.includes(head), `${heads}`);
  assert.ok(!heads.some((head) => /edge|colour/.test(head)), `${heads}`);
  await page.locator(".plot-heat-map .mark-rect path").first().click();
  await page.waitForFunction(() => location.hash.startsWith("#case=user/box/ramp.friction"));
});

test("names from records stay names in pictures of sweeps", async () => {
  const axes = [HOSTILE, "constructor", "__proto__x"];
  const records = grid({ a: [1, 2], b: [1, 2, 3], c: [1, 2, 3, 4] }).map(({ a, b, c }) => {
    const one = measured({ a, b, c });
    return {
      ...one,
      case: `${HOSTILE}/${a}-${b}-${c}`,
      axes: [a, b, c].map((value, i) => ({ name: axes[i], unit: HOSTILE, value })),
      checks: one.checks.map((check) => ({
        ...check,
        quantity: `${HOSTILE}${check.quantity}`,
        unit: HOSTILE,
      })),
      environment: { ...one.environment, host: HOSTILE },
    };
  });
  const page = await browser.open(page_of(records));
  await page.locator(".plot-phase-diagram").waitFor();
  await draw_plots(page);
  await turn_to(page, "#plots=heat-map");
  await page.locator(".plot-heat-map").first().waitFor();
  await draw_plots(page);
  await turn_to(page, "#about");
  assert.match(await page.locator("table.environments").innerText(), /<img src=x/);
  assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
  assert.equal(await page.getByText("cannot be drawn").count(), 0);
  assert.deepEqual(page.faults, []);
});

test("where marks lie on each other, what failed is drawn last", () => {
  const cube = grid({ a: steps(1, 3, 3), b: steps(1, 3, 3), c: steps(1, 3, 3), d: steps(1, 3, 3) });
  const verdict_of = ({ a, b, c, d }) => (a + b + c + d === 8 ? "fail" : "pass");
  const folder = make_run(lines_of(cube.map((axes) => point(axes, { verdict: verdict_of(axes) }))));
  const pictures = join(temporary_folder(), "svg");
  const { status, err } = report(folder, "--out", join(folder, "page.html"), "--svg", pictures);
  assert.equal(status, 0, err);
  const name = readdirSync(pictures).find((file) => file.includes("phase-diagram"));
  const groups = readFileSync(join(pictures, name), "utf8").split('class="mark-symbol').slice(1);
  const panels = groups
    .map((text) =>
      [...text.split("</g>")[0].matchAll(/fill="(#\w+)"/g)].map(([, colour]) => colour),
    )
    .filter((colours) => colours.length === cube.length);
  assert.equal(panels.length, 6, "a panel for each pair of axes");
  for (const colours of panels) {
    const failed = cube.filter((axes) => verdict_of(axes) === "fail").length;
    assert.deepEqual(new Set(colours.slice(-failed)), new Set([PALETTES.light.$fail]));
    assert.ok(!colours.slice(0, -failed).includes(PALETTES.light.$fail));
  }
});

test("they are written as SVG files too", () => {
  const folder = temporary_folder();
  const points = grid({ mu: [0.1, 0.2, 0.3], slope_deg: [1, 2], mass: [1, 2] }).map((axes) =>
    point(axes),
  );
  const { status, err } = report(
    make_run(lines_of(points)),
    "--out",
    join(folder, "page.html"),
    "--svg",
    join(folder, "svg"),
  );
  assert.equal(status, 0, err);
  const [name] = readdirSync(join(folder, "svg")).filter((file) =>
    file.startsWith("user_box_phase-diagram"),
  );
  assert.match(readFileSync(join(folder, "svg", name), "utf8"), /mass = 1.*mass = 2/s);
});
