// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of all families, by what they show.
import { MAP_KINDS } from "../../model/map_kind.js";
import { h, replace } from "../dom.js";
import { plot_figure } from "../widgets/plot_figure.js";
import { plots_of_family } from "../records.js";
import { hash_of } from "../route.js";

const KINDS = {
  "phase-diagram": "Sweeps",
  "heat-map": "Measured over sweeps",
  "sweep-cost": "Cost of sweeps",
  scores: "Rules by case",
  "work-precision": "Work and precision",
  ladder: "Ladders",
  threshold: "Thresholds",
  prediction: "Measured against expected",
  trend: "History",
};
const MOST_FAMILIES = 12;

// Pictures over all cases of a folder stand in the index, those of families in parts of their own.
const scores_sections = (scores) =>
  scores.map(({ folder, plots }) =>
    h(
      "section",
      {},
      h("h2", {}, `${folder}/…`),
      h(
        "div",
        { class: "plot-pairs" },
        plots.map((plot) => plot_figure(plot)),
      ),
    ),
  );

export async function show_plots(element, kind, { index }) {
  const present = Object.keys(KINDS).filter(
    (name) =>
      index.families.some(({ plots }) => plots.some((plot) => plot.kind === name)) ||
      (name === "scores" && index.compared?.scores.length > 0),
  );
  const chosen = present.includes(kind) ? kind : present[0];
  const families = index.families.filter(({ plots }) => plots.some((plot) => plot.kind === chosen));
  const sections = await Promise.all(
    families.slice(0, MOST_FAMILIES).map(async ({ name }) => {
      const plots = (
        await plots_of_family(name, index, { maps: MAP_KINDS.includes(chosen) })
      ).filter((plot) => plot.kind === chosen);
      const title = (plot) => (plots.length > 1 ? plot.title : ""); // the tab says it already
      return plots.map((plot) =>
        h(
          "section",
          { class: plot.wide ? "plot-wide" : "" },
          h("h2", {}, h("a", { href: hash_of("family", name) }, name)),
          plot_figure({ ...plot, title: title(plot), wide: false }),
        ),
      );
    }),
  );
  replace(
    element,
    h("h1", {}, "Plots"),
    present.length === 0
      ? h("p", {}, "The records hold nothing to plot over a family; each case has its own.")
      : h(
          "nav",
          { class: "tabs", "aria-label": "Kinds of plots" },
          present.map((name) =>
            h(
              "a",
              { href: hash_of("plots", name), "aria-current": name === chosen ? "true" : null },
              KINDS[name],
            ),
          ),
        ),
    chosen === "scores"
      ? scores_sections(index.compared.scores)
      : h("div", { class: "plot-grid" }, sections),
    families.length > MOST_FAMILIES &&
      h("p", {}, `${families.length - MOST_FAMILIES} more families: see each family's own page.`),
  );
}
