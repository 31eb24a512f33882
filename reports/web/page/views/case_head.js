// SPDX-License-Identifier: GPL-3.0-or-later
// The head of a case's page: where it stands among others, its name, what it comes to.
import { is_answer, is_engine_case } from "../../model/engine.js";
import { rung_of } from "../../model/ladder.js";
import { is_perturbed } from "../../model/perturbation.js";
import { is_bad } from "../../model/verdict.js";
import { compared_mark } from "./comparison_part.js";
import { breakable, h } from "../dom.js";
import { answers_mark, judged_mark } from "./engine_case_part.js";
import { verdict_mark } from "../widgets/glyph.js";
import { case_hash, hash_of } from "../route.js";

function neighbours(name, names) {
  const place = names.indexOf(name);
  const link = (target, text, rel) =>
    target === undefined
      ? h("span", { class: "off" }, text)
      : h("a", { href: case_hash(target), rel }, text);
  return h(
    "nav",
    { class: "neighbours", "aria-label": "Neighbouring cases" },
    link(place > 0 ? names[place - 1] : undefined, "← previous", "prev"),
    link(place >= 0 ? names[place + 1] : undefined, "next →", "next"),
  );
}

// A perturbed case and a rung stand in a view of their own beside their like.
function stability_crumb(name) {
  const rung = rung_of(name);
  if (!rung && !is_perturbed(name)) return null;
  const place = rung ? `${rung.ladder}/${rung.parameter}` : "";
  return [" / ", h("a", { href: hash_of("stability", place) }, "Stability")];
}

function case_mark(records, worst, compared) {
  if (is_engine_case(records[0].case)) return answers_mark(records);
  if (records.every(is_answer)) return judged_mark(records);
  return compared && !is_bad(worst) ? compared_mark(records) : verdict_mark(worst, 20);
}

/** `order`: the names of the cases among which previous and next are meant; `worst`: verdict. */
export const case_head = ({ name, family, records, worst, compared, order, stability }) =>
  h(
    "div",
    { class: "case-head" },
    h(
      "p",
      { class: "crumbs" },
      is_engine_case(name)
        ? h("a", { href: hash_of("summary") }, "All engines")
        : [
            h("a", { href: hash_of("cases") }, "Cases"),
            " / ",
            h("a", { href: hash_of("family", family) }, family),
            stability && stability_crumb(name),
          ],
    ),
    neighbours(name, order),
    h("h1", { id: "case-title" }, breakable(name)),
    h("p", { class: "case-title" }, case_mark(records, worst, compared), records[0].title),
  );
