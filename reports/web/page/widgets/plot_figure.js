// SPDX-License-Identifier: GPL-3.0-or-later
// A plot in the page: drawn when it comes into view, again when its width or the theme changes, with
// its data as a table for those who would rather read.
import { code_of } from "../asset.js";
import { case_hash } from "../route.js";
import { data_table } from "./data_table.js";
import { h, replace } from "../dom.js";
import { current_theme, on_theme } from "./theme.js";
import { mark_count } from "../../plots/panel_size.js";
import { hide_tip, show_tip } from "./tip.js";

const MOST_ELEMENTS = 3000; // of an SVG; beyond that a canvas is drawn faster

const live = new Set();

const seen = new IntersectionObserver(
  (entries) => {
    for (const { target, isIntersecting } of entries) {
      if (isIntersecting) target.stiction_draw?.();
    }
  },
  { rootMargin: "200px" },
);

const sized = new ResizeObserver((entries) => {
  for (const { target } of entries) {
    const width = Math.floor(target.clientWidth);
    if (target.stiction_view && Math.abs(width - target.stiction_width) > 4)
      target.stiction_draw(true);
  }
});

on_theme(() => {
  for (const canvas of live) {
    if (!canvas.isConnected) live.delete(canvas);
    else if (canvas.stiction_view) canvas.stiction_draw(true);
  }
});

function save(name, type, text) {
  const link = h("a", { download: name, href: URL.createObjectURL(new Blob([text], { type })) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** `on_click(datum)` is told of clicks on marks; without it a mark's case is opened. */
export function plot_figure(plot, { heading = "h3", on_click } = {}) {
  const canvas = h("div", { class: "plot-canvas", role: "img", "aria-label": plot.description });
  let drawing = false;

  canvas.stiction_draw = async (again = false) => {
    if (drawing || (canvas.stiction_view && !again)) return;
    drawing = true;
    try {
      const { view_of } = await code_of("code/plot", "stiction_plot");
      const width = Math.floor(canvas.clientWidth);
      if (width < 40) return;
      canvas.stiction_view?.finalize();
      canvas.stiction_width = width;
      const renderer = mark_count(plot.spec) > MOST_ELEMENTS ? "canvas" : "svg";
      const on_tip = (event, tip) => (tip ? show_tip(event, tip) : hide_tip());
      const view = view_of(plot.spec, current_theme(), width, { renderer, hover: true, on_tip });
      view.addEventListener("click", (event, item) => {
        const datum = item?.datum;
        if (!datum) return;
        if (on_click) on_click(datum);
        else if (typeof datum.case === "string") location.hash = case_hash(datum.case);
      });
      const place = h("div");
      view.initialize(place);
      await view.runAsync();
      place.querySelector("svg, canvas")?.setAttribute("aria-hidden", "true");
      replace(canvas, place);
      canvas.stiction_view = view;
      live.add(canvas);
    } catch (error) {
      replace(canvas, h("p", { class: "message" }, `This plot cannot be drawn: ${error.message}`));
    } finally {
      drawing = false;
    }
  };
  seen.observe(canvas);
  sized.observe(canvas);

  const details = h(
    "details",
    {
      class: "plot-data",
      ontoggle: () => {
        if (details.open && details.children.length === 1) details.append(data_table(plot.spec));
      },
    },
    h("summary", {}, "Data"),
  );
  const save_svg = async () => {
    const { svg_of, svg_width } = await code_of("code/plot", "stiction_plot");
    save(
      "plot.svg",
      "image/svg+xml",
      await svg_of(
        { ...(plot.title && { title: plot.title }), ...plot.spec },
        "light",
        svg_width(plot),
      ),
    );
  };
  return h(
    "figure",
    { class: `plot plot-${plot.kind}${plot.wide ? " plot-wide" : ""}`, "data-plot": plot.id },
    plot.title && h(heading, { class: "plot-title" }, plot.title),
    canvas,
    plot.caption && h("figcaption", {}, plot.caption),
    h(
      "div",
      { class: "plot-tools" },
      details,
      h("button", { type: "button", class: "quiet", onclick: save_svg }, "Save SVG"),
      h(
        "button",
        {
          type: "button",
          class: "quiet",
          onclick: () =>
            save("plot.vl.json", "application/json", JSON.stringify(plot.spec, null, 1)),
        },
        "Save Vega-Lite",
      ),
    ),
  );
}

/** Draws every plot of an element, wherever it stands: for printing and tests. */
export const draw_all = (root) =>
  Promise.all([...root.querySelectorAll(".plot-canvas")].map((canvas) => canvas.stiction_draw()));
