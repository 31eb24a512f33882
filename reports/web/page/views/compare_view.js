// SPDX-License-Identifier: GPL-3.0-or-later
// Two runs: what changed in verdicts, digits and cost.
import { CHANGE_CLASSES, CHANGE_WORDS } from "../../model/compare.js";
import { format_count, format_error, format_seconds } from "../../model/number.js";
import { breakable, h, replace } from "../dom.js";
import { glyph, verdict_mark } from "../widgets/glyph.js";
import { plot_figure } from "../widgets/plot_figure.js";
import { case_hash, hash_of } from "../route.js";

const MOST_ROWS = 300;

const verdicts = ({ before, after }) =>
  before && after && before.verdict !== after.verdict
    ? [verdict_mark(before.verdict, 14), " → ", verdict_mark(after.verdict, 14)]
    : verdict_mark((after ?? before).verdict, 14);

const signed = (value) => (value === 0 ? "0" : `${value > 0 ? "+" : ""}${value.toFixed(1)}`);

function change_row(change) {
  const { digits_change: digits, cost_ratio: ratio } = change;
  return h(
    "tr",
    { class: `change-${change.class}` },
    h("td", {}, CHANGE_WORDS[change.class]),
    h(
      "th",
      { scope: "row" },
      h("a", { href: case_hash(change.case) }, breakable(change.case)),
      h("span", { class: "variant", title: change.variant }, change.label),
    ),
    h("td", { class: "verdicts" }, verdicts(change)),
    h(
      "td",
      { class: "number" },
      change.before && change.after ? h("span", { title: change.quantity }, signed(digits)) : "–",
    ),
    h(
      "td",
      { class: "number" },
      change.before ? format_seconds(Number(change.before.seconds)) : "–",
    ),
    h("td", { class: "number" }, change.after ? format_seconds(Number(change.after.seconds)) : "–"),
    h("td", { class: "number" }, ratio === null ? "–" : `× ${format_error(ratio)}`),
    h("td", {}, change.hash_equal === null ? "–" : change.hash_equal ? "same" : "differs"),
  );
}

export function show_compare(element, chosen, { index, comparison }) {
  const { counts, changes, total, seconds, plots } = comparison;
  const run_line = (role, words) => {
    const runs = index.runs.filter((run) => run.role === role);
    return h(
      "li",
      {},
      `${words}: `,
      runs
        .map(
          (run) =>
            `${run.name} (${run.date.replace("T", " ").replace("Z", " UTC")}, revision ${run.revision})`,
        )
        .join("; "),
    );
  };
  const present = CHANGE_CLASSES.filter((name) => counts[name] > 0);
  const interesting = present.filter((name) => name !== "same");
  const classes = present.includes(chosen)
    ? [chosen]
    : interesting.length > 0
      ? interesting
      : present;
  const shown = changes.filter((change) => classes.includes(change.class));
  const worse = counts.worse ?? 0;
  const ratio = seconds.before > 0 ? seconds.after / seconds.before : NaN;
  replace(
    element,
    h(
      "div",
      { class: "headline" },
      glyph(worse > 0 ? "fail" : "pass", 36),
      h(
        "div",
        {},
        h(
          "h1",
          { class: worse > 0 ? "verdict-fail" : "verdict-pass" },
          worse > 0
            ? `${format_count(worse)} verdict${worse === 1 ? "" : "s"} became worse.`
            : "No verdict became worse.",
        ),
        h(
          "p",
          { class: "subline" },
          `${format_count(total)} records paired by case, engine and settings; CPU time of the pairs ${format_seconds(seconds.before)} s → ${format_seconds(seconds.after)} s${Number.isFinite(ratio) ? ` (× ${format_error(ratio)})` : ""}.`,
        ),
        h("ul", { class: "run-lines" }, run_line("against", "earlier"), run_line("shown", "this")),
      ),
    ),
    h(
      "nav",
      { class: "tabs", "aria-label": "Kinds of change" },
      h(
        "a",
        { href: hash_of("compare"), "aria-current": present.includes(chosen) ? null : "true" },
        "changed",
      ),
      present.map((name) =>
        h(
          "a",
          { href: hash_of("compare", name), "aria-current": chosen === name ? "true" : null },
          `${CHANGE_WORDS[name]} `,
          h("span", { class: "count" }, format_count(counts[name])),
        ),
      ),
    ),
    h(
      "div",
      { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "Changes" },
      h(
        "table",
        { class: "changes" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            [
              ["Change"],
              ["Case"],
              ["Verdict"],
              ["Digits", 1],
              ["CPU before s", 1],
              ["CPU now s", 1],
              ["Ratio", 1],
              ["End state"],
            ].map(([name, number]) =>
              h("th", { scope: "col", class: number ? "number" : "" }, name),
            ),
          ),
        ),
        h("tbody", {}, shown.slice(0, MOST_ROWS).map(change_row)),
      ),
    ),
    shown.length > MOST_ROWS &&
      h("p", {}, `The first ${MOST_ROWS} of ${format_count(shown.length)}.`),
    h(
      "div",
      { class: "plot-grid" },
      plots.map((plot) => plot_figure(plot, { heading: "h2" })),
    ),
  );
}
