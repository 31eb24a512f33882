// SPDX-License-Identifier: GPL-3.0-or-later
// What each variant of a case cost, with what and where.
import { format_count, format_seconds, format_value, to_number } from "../../model/number.js";
import { machine_letters } from "../../model/machine.js";
import { h } from "../dom.js";
import { machine_mark, machines_note } from "../widgets/machine_mark.js";
import { configuration_name } from "./results_table.js";
import { verdict_mark } from "../widgets/glyph.js";

const settings_text = (settings) =>
  Object.entries(settings)
    .map(([name, value]) => `${name}=${value}`)
    .join(" ");

const rate_text = ({ cpu_seconds, simulated_seconds = 0 }) =>
  to_number(simulated_seconds) > 0
    ? format_seconds(to_number(cpu_seconds) / to_number(simulated_seconds))
    : "–";

// Median over the timed steps, and its quartiles where the record has them.
function time_text(cost, name) {
  const short = (value) => format_value(Number(to_number(value).toPrecision(3)));
  const median = to_number(cost[name] ?? 0);
  if (!(median > 0)) return "–";
  const [lower, upper] = (cost[`${name}_quartiles`] ?? [0, 0]).map(to_number);
  return upper > 0 ? `${short(median)} (${short(lower)} to ${short(upper)})` : short(median);
}

/** `entries`: [{record, label, run}]; without settings each is told by its configuration. */
export function cost_table(entries, { with_settings = true } = {}) {
  const heading = (name, unit, number = true) =>
    h(
      "th",
      { scope: "col", class: number ? "number" : "" },
      name,
      unit && h("span", { class: "unit" }, ` ${unit}`),
    );
  const letters = machine_letters(entries.map(({ record }) => record));
  const machine = (record) => machine_mark(letters([record]));
  const table = h(
    "div",
    { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "Cost" },
    h(
      "table",
      { class: "costs" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          heading("Verdict", "", false),
          heading(with_settings ? "Engine and settings" : "Configuration", "", false),
          heading("CPU", "s"),
          heading("CPU a second", "s/s"),
          heading("Steps"),
          heading("Contact updates"),
          heading("Step", "ns a contact"),
          heading("Contact phases", "ns a contact"),
          heading("State hash", "", false),
        ),
      ),
      h(
        "tbody",
        {},
        entries.map(({ record, label, run }) =>
          h(
            "tr",
            {},
            h("td", {}, verdict_mark(record.verdict, 15)),
            h(
              "th",
              { scope: "row" },
              with_settings
                ? [
                    `${run ? `${run} · ` : ""}${record.engine} `,
                    h("span", { class: "variant" }, settings_text(record.settings)),
                  ]
                : configuration_name({ record, label }),
            ),
            h(
              "td",
              { class: "number" },
              format_seconds(to_number(record.cost.cpu_seconds)),
              machine(record),
            ),
            h("td", { class: "number" }, rate_text(record.cost)),
            h("td", { class: "number" }, format_count(record.cost.steps)),
            h("td", { class: "number" }, format_count(record.cost.contact_updates)),
            h("td", { class: "number" }, time_text(record.cost, "ns_per_contact_step")),
            h("td", { class: "number" }, time_text(record.cost, "ns_per_contact_update")),
            h("td", {}, h("code", {}, record.state_hash || "–")),
          ),
        ),
      ),
    ),
  );
  return [machines_note(entries.map(({ record }) => letters([record]))), table];
}
