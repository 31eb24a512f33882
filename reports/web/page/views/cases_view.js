// SPDX-License-Identifier: GPL-3.0-or-later
// All records: search, filter, sort. Its state is the page's address.
import { ordered_configurations } from "../../model/configuration.js";
import { VERDICTS, VERDICT_WORDS } from "../../model/verdict.js";
import { format_count } from "../../model/number.js";
import { case_columns } from "./case_columns.js";
import { h, replace } from "../dom.js";
import { filtered, sorted } from "../widgets/filter.js";
import { glyph } from "../widgets/glyph.js";
import { case_hash, hash_of } from "../route.js";
import { machines_note } from "../widgets/machine_mark.js";
import { big_table } from "../widgets/table.js";

const SORTS = {
  verdict: "verdict, failures first",
  case: "case name",
  "-margin": "closest to the limit",
  digits: "fewest digits",
  "-seconds": "most CPU time",
  "-ns": "slowest contact",
};

/** Gives {element, show(options), list(): the rows in view, search: the field, table}. */
export function cases_view({ index, rows }) {
  const current = rows.filter((row) => index.runs[row.run].role === "shown");
  let options = {};
  let listed = current;

  // At once, not when the browser tells of the new address: a second click may come before.
  const go = (change) => {
    options = change ? { ...options, ...change } : {};
    location.replace(hash_of("cases", "", options));
  };
  const counts = Object.fromEntries(
    VERDICTS.map((verdict) => [verdict, current.filter((row) => row.verdict === verdict).length]),
  );
  const search = h("input", {
    type: "search",
    id: "search",
    placeholder: "Search cases, settings, quantities",
    "aria-label": "Search",
    autocomplete: "off",
    spellcheck: "false",
  });
  let waiting = 0;
  search.addEventListener("input", () => {
    clearTimeout(waiting);
    waiting = setTimeout(() => go({ q: search.value }), current.length > 5000 ? 180 : 60);
  });
  const toggles = VERDICTS.filter((verdict) => counts[verdict] > 0).map((verdict) =>
    h(
      "button",
      {
        type: "button",
        class: `toggle verdict-${verdict}`,
        "data-verdict": verdict,
        "data-term": verdict,
        onclick: () => {
          const chosen = new Set((options.verdict ?? "").split(",").filter(Boolean));
          if (!chosen.delete(verdict)) chosen.add(verdict);
          go({ verdict: [...chosen].join(",") });
        },
      },
      glyph(verdict, 14),
      ` ${VERDICT_WORDS[verdict]} `,
      h("span", { class: "count" }, format_count(counts[verdict])),
    ),
  );
  const choice = (name, label, entries) =>
    h(
      "label",
      { class: "choice" },
      h("span", {}, label),
      h(
        "select",
        { name, onchange: (event) => go({ [name]: event.target.value }) },
        entries.map(([value, text]) => h("option", { value }, text)),
      ),
    );
  const families = [...new Set(current.map((row) => row.family))];
  const family = choice("family", "Family", [["", "all"], ...families.map((name) => [name, name])]);
  const columns = ordered_configurations(current.map((row) => row.column));
  const configuration =
    columns.length > 1 &&
    choice("configuration", "Configuration", [["", "all"], ...columns.map((name) => [name, name])]);
  const sort = choice("sort", "Sort by", Object.entries(SORTS));
  const shown_runs = index.runs.map((run, i) => [i, run]).filter(([, run]) => run.role === "shown");
  const run =
    shown_runs.length > 1 &&
    choice("run", "Run", [["", "all"], ...shown_runs.map(([i, { name }]) => [String(i), name])]);
  const count = h("p", { class: "count-line", role: "status" });

  const table = big_table({
    columns: case_columns(index.runs),
    label: "Records",
    on_sort: (key) => {
      const now = options.sort ?? "verdict";
      const falling = ["margin", "seconds", "ns"].includes(key);
      const forward = falling ? `-${key}` : key;
      const backward = falling ? key : `-${key}`;
      go({ sort: now === forward ? backward : forward });
    },
    open: (row) => (location.hash = case_hash(row.case)),
  });

  const reset = h("button", { type: "button", class: "quiet", onclick: () => go(null) }, "Clear");
  const element = h(
    "section",
    { class: "view view-cases", "aria-labelledby": "cases-title" },
    h("h1", { id: "cases-title" }, "Cases"),
    h(
      "div",
      { class: "filters", role: "search" },
      search,
      h("div", { class: "toggles", role: "group", "aria-label": "Verdicts" }, toggles),
      family,
      configuration,
      run,
      sort,
      reset,
    ),
    count,
    machines_note(current.map((row) => row.machine)),
    table.element,
  );

  return {
    element,
    search,
    table,
    list: () => listed,
    show(next) {
      options = next;
      if (document.activeElement !== search) search.value = options.q ?? "";
      const chosen = new Set((options.verdict ?? "").split(","));
      for (const toggle of toggles)
        toggle.setAttribute("aria-pressed", chosen.has(toggle.dataset.verdict));
      family.lastChild.value = options.family ?? "";
      if (configuration) configuration.lastChild.value = options.configuration ?? "";
      if (run) run.lastChild.value = options.run ?? "";
      const order = options.sort ?? "verdict";
      if (!(order in SORTS)) {
        const [key, falling] = [order.replace(/^-/, ""), order.startsWith("-")];
        if (![...sort.lastChild.options].some(({ value }) => value === order)) {
          sort.lastChild.append(
            h("option", { value: order }, `${key}, ${falling ? "largest" : "smallest"} first`),
          );
        }
      }
      sort.lastChild.value = order;
      listed = sorted(filtered(current, options), order);
      replace(
        count,
        document.createTextNode(
          listed.length === current.length
            ? `${format_count(current.length)} records`
            : `${format_count(listed.length)} of ${format_count(current.length)} records`,
        ),
      );
      table.show(listed, order);
    },
  };
}
