// SPDX-License-Identifier: GPL-3.0-or-later
// How to run a case again.
import { case_command, record_command } from "../../model/rerun.js";
import { h } from "../dom.js";
import { command } from "../widgets/command.js";
import { configuration_name } from "./results_table.js";

const row = (name, text, told) => h("div", {}, h("dt", {}, name), h("dd", {}, command(text, told)));

/** `entries`: [{record, label}]. */
export function rerun_part(entries) {
  const whole = new Set(entries.map(({ record }) => case_command(record)));
  const single = new Map(
    entries
      .map((entry) => [record_command(entry.record), entry])
      .filter(([text]) => text !== "" && entries.length > 1),
  );
  return [
    h("h2", {}, "Run it again"),
    h(
      "dl",
      { class: "commands" },
      [...whole].map((text) =>
        row(entries.length > 1 ? "all of them" : "this case", text, "the case"),
      ),
      [...single].map(([text, entry]) => row(configuration_name(entry), text, entry.label)),
    ),
  ];
}
