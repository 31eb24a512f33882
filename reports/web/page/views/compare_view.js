// SPDX-License-Identifier: GPL-3.0-or-later
// Two runs: what changed in verdicts, digits and cost beyond noise; the rest is counted, and folded.
import { CHANGE_CLASSES, CHANGE_WORDS, LEAST_SECONDS, SAME_WORDS } from "../../model/compare.js";
import { format_count, format_error, format_seconds } from "../../model/number.js";
import { breakable, h, replace } from "../dom.js";
import { glyph, verdict_mark } from "../widgets/glyph.js";
import { machine_mark, machines_note } from "../widgets/machine_mark.js";
import { plot_figure } from "../widgets/plot_figure.js";
import { case_hash, hash_of } from "../route.js";

const MOST_ROWS = 300;

const verdicts = ({ before, after }) =>
  before && after && before.verdict !== after.verdict
    ? [verdict_mark(before.verdict, 14), " → ", verdict_mark(after.verdict, 14)]
    : verdict_mark((after ?? before).verdict, 14);

const signed = (value) => (value === 0 ? "0" : `${value > 0 ? "+" : ""}${value.toFixed(1)}`);

const seconds_cell = (one) =>
  one ? [format_seconds(Number(one.seconds)), machine_mark(one.machine)] : "–";

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
    h("td", { class: "number" }, seconds_cell(change.before)),
    h("td", { class: "number" }, seconds_cell(change.after)),
    h("td", { class: "number" }, ratio === null ? "–" : `× ${format_error(ratio)}`),
    h("td", {}, change.hash_equal === null ? "–" : change.hash_equal ? "same" : "differs"),
  );
}

const changes_table = (changes, label) => [
  h(
    "div",
    { class: "data-scroll", tabindex: "0", role: "region", "aria-label": label },
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
          ].map(([name, number]) => h("th", { scope: "col", class: number ? "number" : "" }, name)),
        ),
      ),
      h("tbody", {}, changes.slice(0, MOST_ROWS).map(change_row)),
    ),
  ),
  changes.length > MOST_ROWS &&
    h("p", {}, `The first ${MOST_ROWS} of ${format_count(changes.length)}.`),
];

const percent = (factor) => `${Math.round(100 * (factor - 1))} %`;

// What counts as noise, in words, with how many pairs that leaves out.
function noise_words({ machines, pairs, factor, median }) {
  const where = !machines
    ? ""
    : machines[0] === machines[1]
      ? `On machine ${machines[0]} `
      : `From machine ${machines[0]} to ${machines[1]} `;
  return (
    `${where}CPU time counts beyond ± ${percent(factor)}` +
    `${median === 1 ? "" : ` of the median pair, × ${format_error(median)}`} ` +
    `(the spread of ${format_count(pairs)} pairs, at least 15 %)`
  );
}

function left_out({ unchanged, noises, counts, changes }) {
  const same = counts.same ?? 0;
  if (same === 0) return null;
  const reasons = Object.entries(unchanged.by_reason).map(([reason, count]) =>
    h("li", {}, `${format_count(count)}: ${SAME_WORDS[reason]}`),
  );
  const short =
    unchanged.untimed > 0
      ? `${format_count(unchanged.untimed)} took less than ${LEAST_SECONDS} s, too short to compare`
      : "";
  const moved =
    unchanged.moved > 0
      ? `${format_count(unchanged.moved)} ran on another machine than before, too few to compare`
      : "";
  const body = h("div");
  const details = h(
    "details",
    {
      class: "unchanged",
      ontoggle: () => {
        if (!details.open || body.children.length > 0) return;
        replace(
          body,
          changes_table(
            changes.filter((change) => change.class === "same"),
            "Unchanged",
          ),
        );
      },
    },
    h("summary", {}, `${format_count(same)} unchanged within noise`),
    body,
  );
  return h(
    "section",
    { class: "left-out" },
    details,
    h(
      "ul",
      {},
      reasons,
      [...noises.map(noise_words), short, moved]
        .filter(Boolean)
        .map((text) => h("li", {}, `${text}.`)),
    ),
  );
}

const plural = (count, one, many = `${one}s`) =>
  `${format_count(count)} ${count === 1 ? one : many}`;

const HEAD = {
  worse: (count) => `${plural(count, "verdict")} became worse`,
  gone: (count) => `${plural(count, "record is", "records are")} gone`,
  "fewer-digits": (count) => `${format_count(count)} with fewer digits`,
  slower: (count) => `${format_count(count)} slower`,
  better: (count) => `${plural(count, "verdict")} became better`,
  "more-digits": (count) => `${format_count(count)} with more digits`,
  faster: (count) => `${format_count(count)} faster`,
  new: (count) => `${format_count(count)} new`,
};

function headline(counts) {
  const said = Object.entries(HEAD)
    .filter(([name]) => counts[name] > 0)
    .map(([name, write]) => write(counts[name]));
  if (said.length === 0) return "Nothing changed beyond noise.";
  return `${counts.worse > 0 ? "" : "No verdict became worse; "}${said.join(", ")}.`;
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
  const present = CHANGE_CLASSES.filter((name) => counts[name] > 0 && name !== "same");
  const classes = present.includes(chosen) ? [chosen] : present;
  const shown = changes.filter((change) => classes.includes(change.class));
  const worse = counts.worse ?? 0;
  const moved = changes.some(
    ({ before, after }) => before && after && before.machine !== after.machine,
  );
  const ratio = !moved && seconds.before > 0 ? seconds.after / seconds.before : NaN;
  replace(
    element,
    h(
      "div",
      { class: "headline" },
      glyph(worse > 0 ? "fail" : "pass", 36),
      h(
        "div",
        {},
        h("h1", { class: worse > 0 ? "verdict-fail" : "verdict-pass" }, headline(counts)),
        h(
          "p",
          { class: "subline" },
          `${format_count(total)} records paired by case, engine and settings; CPU time of the pairs ${format_seconds(seconds.before)} s → ${format_seconds(seconds.after)} s${Number.isFinite(ratio) ? ` (× ${format_error(ratio)})` : ""}.`,
        ),
        machines_note(
          changes.flatMap(({ before, after }) => [before, after]).map((one) => one?.machine ?? ""),
        ),
        h("ul", { class: "run-lines" }, run_line("against", "earlier"), run_line("shown", "this")),
      ),
    ),
    present.length > 1 &&
      h(
        "nav",
        { class: "tabs", "aria-label": "Kinds of change" },
        h(
          "a",
          { href: hash_of("compare"), "aria-current": present.includes(chosen) ? null : "true" },
          "all changes",
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
    shown.length > 0 && changes_table(shown, "Changes"),
    left_out(comparison),
    plots.length > 0 &&
      h(
        "div",
        { class: "plot-grid" },
        plots.map((plot) => plot_figure(plot, { heading: "h2" })),
      ),
  );
}
