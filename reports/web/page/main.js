// SPDX-License-Identifier: GPL-3.0-or-later
// The page: reads the index, shows the view that the address names.
import { show_about } from "./views/about_view.js";
import { json_of } from "./asset.js";
import { show_case } from "./views/case_view.js";
import { cases_view } from "./views/cases_view.js";
import { show_compare } from "./views/compare_view.js";
import { h, replace } from "./dom.js";
import { show_family } from "./views/family_view.js";
import { page_header, warnings_box } from "./widgets/header.js";
import { start_keys } from "./widgets/keys.js";
import { draw_all } from "./widgets/plot_figure.js";
import { show_plots } from "./views/plots_view.js";
import { hash_of, parse_hash } from "./route.js";
import { know_machines } from "../model/machine.js";
import { know_configurations } from "../plots/configuration_style.js";
import { rows_of } from "./rows.js";
import { show_stability } from "./views/stability_view.js";
import { summary_view } from "./views/summary_view.js";
import { start_terms } from "./widgets/term.js";
import { start_theme } from "./widgets/theme.js";
import { hide_tip } from "./widgets/tip.js";

const MOST_ON_PAPER = 1000;

async function start(app) {
  const index = await json_of("index");
  const comparison = index.runs.some(({ role }) => role === "against")
    ? await json_of("comparison")
    : null;
  know_configurations(index.configurations);
  know_machines(index.machines);
  const data = { index, rows: rows_of(index), comparison };
  const views = [
    ["summary", "Summary"],
    ["cases", "Cases"],
    ["plots", "Plots"],
    ...(index.stability ? [["stability", "Stability"]] : []),
    ...(comparison ? [["compare", "Compare"]] : []),
    ["about", "About"],
  ];
  const header = page_header(index.title, views);
  const main = h("main", { tabindex: "-1" });
  replace(app, header.element, warnings_box(index.warnings), main);

  const summary = summary_view(data);
  const cases = cases_view(data);
  const detail = h("section", { class: "view" });
  const shown_later = {
    case: show_case,
    family: show_family,
    plots: show_plots,
    stability: index.stability && show_stability,
    compare: comparison && show_compare,
    about: show_about,
  };
  const marked = { case: "cases", family: "summary" };
  let view = "";
  let cases_hash = hash_of("cases");
  let place = "";

  async function show() {
    hide_tip();
    const route = parse_hash(location.hash);
    const next = route.view === "cases" || shown_later[route.view] ? route.view : "summary";
    const moved = `${next} ${route.value}` !== place;
    place = `${next} ${route.value}`;
    view = next;
    header.mark(marked[view] ?? view);
    if (view === "summary") {
      if (main.firstChild !== summary) replace(main, summary);
    } else if (view === "cases") {
      cases_hash = location.hash;
      if (main.firstChild !== cases.element) replace(main, cases.element);
      cases.show(route.options);
    } else {
      detail.className = `view view-${view}`;
      replace(main, detail);
      const mine = place;
      const fresh = h("div", { class: "view-content" });
      try {
        await shown_later[view](fresh, route.value, data, cases.list(), route.options);
      } catch (error) {
        replace(
          fresh,
          h("h1", {}, "This part cannot be shown"),
          h("p", { class: "message" }, error.message),
        );
      }
      if (mine !== place) return;
      for (const player of detail.querySelectorAll(".player")) player.stiction_end();
      replace(detail, fresh);
    }
    if (moved) {
      scrollTo(0, 0);
      const heading = main.querySelector("h1")?.textContent ?? "";
      document.title = view === "summary" ? index.title : `${heading} · ${index.title}`;
    }
    // For tests: whether what they see is what the address asks for.
    document.documentElement.dataset.shown = location.hash;
  }

  addEventListener("hashchange", show);
  addEventListener("beforeprint", () => {
    if (view === "cases") cases.table.expand(MOST_ON_PAPER);
    for (const folded of main.querySelectorAll("details.folded")) folded.open = true;
    draw_all(main);
  });
  addEventListener("afterprint", () => view === "cases" && cases.table.collapse());
  start_keys({
    views: views.map(([name]) => name),
    view: () => view,
    cases,
    back: () => (location.hash = cases_hash),
  });
  await show();
  document.documentElement.dataset.ready = "true";
}

start_theme();
start_terms();
const app = document.getElementById("app");
start(app).catch((error) =>
  replace(
    app,
    h(
      "main",
      {},
      h("h1", {}, "This report cannot be shown"),
      h("p", { class: "message" }, error.message),
    ),
  ),
);
