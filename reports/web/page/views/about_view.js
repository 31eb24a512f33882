// SPDX-License-Identifier: GPL-3.0-or-later
// Where the numbers come from, and whose work the page holds.
import { GLOSSARY } from "../../model/glossary.js";
import { format_count } from "../../model/number.js";
import { json_of } from "../asset.js";
import { h, replace } from "../dom.js";

// Old records name no host.
const hosts_words = (hosts) =>
  hosts.map(({ name, records }) => `${name}: ${format_count(records)}`).join(", ") || "–";

function environments_part(environments, several_runs) {
  const lettered = environments.some(({ letter }) => letter !== "");
  const names = ["Machine", "Toolchain", "Revision", "Hosts, with their records", "Records"];
  const row = ({ run, letter, machine, toolchain, revision, hosts, records }) =>
    h(
      "tr",
      {},
      lettered && h("th", { scope: "row" }, letter),
      several_runs && h("td", {}, run),
      [machine, toolchain, revision, hosts_words(hosts)].map((text) => h("td", {}, text)),
      h("td", { class: "number" }, format_count(records)),
    );
  return [
    h("h2", {}, "Where they ran"),
    h(
      "div",
      { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "Where they ran" },
      h(
        "table",
        { class: "environments" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            [lettered && "Called", several_runs && "Run", ...names]
              .filter(Boolean)
              .map((name) => h("th", { scope: "col" }, name)),
          ),
        ),
        h("tbody", {}, environments.map(row)),
      ),
    ),
  ];
}

export async function show_about(element, part, { index }) {
  const licences = await json_of("licences");
  const run_row = (run) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, run.name, run.role === "against" && " (earlier)"),
      h("td", {}, run.date),
      h("td", {}, run.revision),
      h("td", { class: "number" }, String(run.records)),
    );
  replace(
    element,
    h("h1", {}, "About this page"),
    h("h2", {}, "Runs"),
    h(
      "div",
      { class: "data-scroll", tabindex: "0", role: "region", "aria-label": "Runs" },
      h(
        "table",
        {},
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            ["Run", "Date", "Revision", "Records"].map((name) => h("th", { scope: "col" }, name)),
          ),
        ),
        h("tbody", {}, index.runs.map(run_row)),
      ),
    ),
    environments_part(index.environments, index.runs.length > 1),
    h("h2", {}, "How to read it"),
    h(
      "p",
      {},
      "A check holds when |error| ≤ tolerance. An expected shortfall does not hold, but its value lies in a band that was stated beforehand with its measured cause; refuted says the same of a claim of the paper, which was tested and found not to hold. Outside its band, on either side, a check fails. The bars show |error| ÷ tolerance on a logarithmic scale with the limit marked. Digits are −log₁₀ of the error over the size of the quantity, at most 16; where zero is expected and nothing says of what size there are none. Times are CPU seconds of the engine's steps; those of different machines or toolchains don't compare, so each has a letter where a view shows several. Unless a unit stands beside it, a number is dimensionless; all units are SI.",
    ),
    h(
      "p",
      {},
      "The page was made from records alone and holds everything it shows; it opens no connection, and its policy forbids any.",
    ),
    h("h2", { id: "words" }, "What the words mean"),
    h(
      "dl",
      { class: "glossary" },
      GLOSSARY.map(({ name, meaning }) => [h("dt", {}, name), h("dd", {}, meaning)]),
    ),
    h("h2", {}, "Third-party software in this page"),
    h(
      "p",
      {},
      "The page's own code and stiction's programs are GPL-3.0-or-later. It holds these packages:",
    ),
    h(
      "div",
      { class: "licences" },
      licences.map((one) =>
        h(
          "details",
          {},
          h("summary", {}, `${one.name} ${one.version}, ${one.licence}`),
          h("pre", {}, one.text || "The package carries no licence text."),
        ),
      ),
    ),
  );
  if (part === "words") setTimeout(() => element.querySelector("#words").scrollIntoView());
}
