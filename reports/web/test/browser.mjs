// SPDX-License-Identifier: GPL-3.0-or-later
// Opens pages in a real browser and notes what must not happen: errors in the console, exceptions,
// anything that leaves the page.
import { createRequire } from "node:module";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { build } from "./report.mjs";
import { temporary_folder } from "./temporary.mjs";

const require = createRequire(join(build, "package.json"));
const { chromium } = require("playwright-core");
export const axe_source = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

const EXECUTABLE = process.env.CHROMIUM ?? "/usr/bin/chromium";
const FLAGS = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];
// Pages turn by so much later than they are asked to: a test that takes the old view for the new one fails
// always, and not on a busy machine only.
const LATE_MS = 100;
const WITH_WEBGL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const WITHOUT_WEBGL = ["--disable-gpu", "--disable-3d-apis"];

function turn_late(ms) {
  const listen = window.addEventListener.bind(window);
  window.addEventListener = (type, told, ...rest) =>
    listen(
      type,
      type === "hashchange" ? (event) => setTimeout(() => told(event), ms) : told,
      ...rest,
    );
}

/** CPU time that the page's process has taken, ms: unlike the clock's it doesn't grow with what else runs. */
async function process_time(page) {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable");
  const { metrics } = await session.send("Performance.getMetrics");
  await session.detach();
  return Math.round(1000 * metrics.find(({ name }) => name === "ProcessTime").value);
}

// How long a page with nothing on it takes to open and to do the work below, ms, on a machine on which the budgets
// hold as they stand. Two idle cores of an EPYC took 360, and 1950 for the page of a whole run; CI's machine opened
// that page within its 1000, so it takes at most 1000 / 1950 · 360 = 185; a fifth less for the spread of both.
const YARDSTICK_MS = 150;

/**
 * How many times as long things take now as on a machine of YARDSTICK_MS, 1 or more. What a page may take is measured
 * against it, clock or CPU time alike: limits in seconds would tell how fast the machine is.
 */
async function slowness(browser) {
  const empty = join(temporary_folder(), "empty.html");
  writeFileSync(empty, "<!doctype html><html data-ready></html>");
  const page = await browser.open(empty);
  const clock_ms = await page.evaluate(() => {
    const start = performance.now();
    const name = (i) => `case ${(i * 7919) % 40_000}`;
    const rows = Array.from({ length: 40_000 }, (_, i) => ({ name: name(i), value: Math.sin(i) }));
    JSON.parse(JSON.stringify(rows)).sort((one, other) => (one.name < other.name ? -1 : 1));
    return performance.now() - start;
  });
  const cpu_ms = await process_time(page);
  await page.context().close();
  return Math.max(1, Math.min(page.ready_ms + clock_ms, cpu_ms) / YARDSTICK_MS);
}

/** Does something on a page: what it would take on a machine of YARDSTICK_MS, as {ms, told}. */
export async function time_of(browser, page, act) {
  const before = await slowness(browser);
  const [start, cpu] = [Date.now(), await process_time(page)];
  await act();
  const taken = [Date.now() - start, (await process_time(page)) - cpu];
  const slow = Math.max(before, await slowness(browser));
  return {
    ms: Math.min(...taken) / slow,
    told: `${taken[0]} ms, CPU ${taken[1]} ms, on a machine ${slow.toFixed(1)} times slower than the budget's`,
  };
}

/**
 * Opens a page, up to three times until it's ready within the budget, of a machine of YARDSTICK_MS, and gives the
 * last, with `told`: what it took, by the clock and in CPU time of its process.
 */
export async function open_within(browser, file, budget_ms, options = {}) {
  const tries = [];
  let in_time = false;
  let page;
  for (let i = 0; i < 3 && !in_time; ++i) {
    await page?.context().close();
    const before = await slowness(browser);
    page = await browser.open(file, options);
    const slow = Math.max(before, await slowness(browser)); // as in time_of
    tries.push(`${page.ready_ms} ms, CPU ${page.ready_cpu_ms} ms, ${slow.toFixed(1)} times slower`);
    in_time = Math.min(page.ready_ms, page.ready_cpu_ms) < budget_ms * slow;
  }
  page.told = `ready in ${tries.join("; ")} than the budget's machine, allowed ${budget_ms} ms there`;
  page.in_time = in_time;
  return page;
}

/**
 * {open(file, {hash, width, height, dark, wait, late_ms}), close()}; each page has `faults`, a list of sentences.
 * Without WebGL, which only recordings need, pictures of thousands of marks are there in a third of the time.
 */
export async function start_browser({ webgl = true } = {}) {
  const browser = await chromium.launch({
    executablePath: EXECUTABLE,
    headless: true,
    args: [...FLAGS, ...(webgl ? WITH_WEBGL : WITHOUT_WEBGL)],
  });
  return {
    async open(
      file,
      { hash = "", width = 1400, height = 900, dark = false, wait = true, late_ms = LATE_MS } = {},
    ) {
      const context = await browser.newContext({
        viewport: { width, height },
        colorScheme: dark ? "dark" : "light",
      });
      const page = await context.newPage();
      await page.addInitScript(turn_late, late_ms);
      page.faults = [];
      const own = pathToFileURL(file).href;
      await context.route("**/*", (route) => {
        const url = route.request().url();
        if (url.split("#")[0] !== own && !url.startsWith("data:"))
          page.faults.push(`request: ${url}`);
        return route.continue();
      });
      page.on("request", (request) => {
        const url = request.url();
        if (url.split("#")[0] !== own && !/^(data|blob):/.test(url))
          page.faults.push(`request: ${url}`);
      });
      page.on(
        "console",
        (message) =>
          ["error", "warning"].includes(message.type()) &&
          page.faults.push(`console: ${message.text()}`),
      );
      page.on("pageerror", (error) => page.faults.push(`exception: ${error.message}`));
      page.on("dialog", (dialog) => page.faults.push(`dialog: ${dialog.message()}`));
      const start = Date.now();
      await page.goto(own + hash);
      if (wait) await page.waitForSelector("[data-ready]", { timeout: 30_000 });
      page.ready_ms = Date.now() - start;
      page.ready_cpu_ms = await process_time(page);
      return page;
    },
    close: () => browser.close(),
  };
}

/** Waits until the page shows what its address asks for: after a click on a link, for example. */
export const turned = (page) =>
  page.waitForFunction(() => document.documentElement.dataset.shown === location.hash, null, {
    timeout: 10_000,
  });

/** Goes to another view of the page, and waits until it's there. */
export async function turn_to(page, hash) {
  await page.evaluate((next) => (location.hash = next), hash);
  await turned(page);
}

/**
 * Scrolls to an element. Unlike Playwright's own way it waits for no frame of the page: in one run of CI the browser
 * gave a page none for half a minute.
 */
export const scroll_to = (locator) =>
  locator.evaluate((element) => element.scrollIntoView({ block: "nearest" }));

/** Frames that a page draws in a second, some 60 of them; in none are plots drawn. */
const frames_of = (page) =>
  page.evaluate(
    () =>
      new Promise((resolve) => {
        let frames = 0;
        const count = () => {
          ++frames;
          requestAnimationFrame(count);
        };
        requestAnimationFrame(count);
        setTimeout(() => resolve(frames), 1000);
      }),
  );

/** Waits until every plot in view, after scrolling to it, has been drawn. Gives their marks' counts. */
export async function draw_plots(page) {
  for (const plot of await page.locator(".plot-canvas").all()) {
    await scroll_to(plot);
    try {
      await plot.locator("svg, canvas").waitFor({ timeout: 10_000 });
    } catch (cause) {
      const frames = await frames_of(page);
      throw new Error(`a plot is not drawn; the page draws ${frames} frames a second`, { cause });
    }
  }
  return page
    .locator(".plot-canvas")
    .evaluateAll((plots) =>
      plots.map(
        (plot) =>
          plot.querySelectorAll(
            ".mark-symbol path, .mark-line path, .mark-rect path, .mark-rule line, .mark-area path",
          ).length,
      ),
    );
}
