// SPDX-License-Identifier: GPL-3.0-or-later
// The data of a specification as a plain table.
import { format_value } from "../../model/number.js";
import { parts_of } from "../../plots/panel_size.js";
import { h } from "../dom.js";

const MOST_ROWS = 200;

// The largest data set of a specification: the measured points, beside helper lines.
function values_of(spec) {
  const sets = parts_of(spec)
    .map((part) => part.data?.values)
    .filter(Boolean);
  return sets.reduce((a, b) => (b.length > a.length ? b : a), []);
}

// Column names as the axes give them, with units, or the marks' tooltips.
function heading_of(spec, field) {
  for (const part of parts_of(spec).reverse()) {
    const channels = Object.values(part.encoding ?? {});
    for (const channel of [...channels, ...(part.encoding?.tooltip ?? [])]) {
      const title = channel?.axis?.title ?? (channel?.type && channel.title);
      if (channel?.field === field && title) return title.trim().replace(/:$/, "");
    }
  }
  return field;
}

const cell = (value) => (typeof value === "number" ? format_value(value) : String(value ?? ""));

export function data_table(spec) {
  const values = values_of(spec);
  const fields = [
    ...new Set(values.slice(0, MOST_ROWS).flatMap((value) => Object.keys(value))),
  ].filter(
    (field) =>
      !/_key$|^place$|^edge_|^colour$/.test(field) &&
      values.some((value) => value[field] !== "" && value[field] !== null),
  );
  return h(
    "div",
    { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "Data of the plot" },
    h(
      "table",
      { class: "data" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          fields.map((field) => h("th", { scope: "col" }, heading_of(spec, field))),
        ),
      ),
      h(
        "tbody",
        {},
        values.slice(0, MOST_ROWS).map((value) =>
          h(
            "tr",
            {},
            fields.map((field) =>
              h(
                "td",
                { class: typeof value[field] === "number" ? "number" : "" },
                cell(value[field]),
              ),
            ),
          ),
        ),
      ),
    ),
    values.length > MOST_ROWS && h("p", {}, `The first ${MOST_ROWS} of ${values.length}.`),
  );
}
