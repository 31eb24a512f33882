// SPDX-License-Identifier: GPL-3.0-or-later
// How much of its tolerance an error takes, as a bar on a logarithmic scale with the limit marked.
import { margin_text, short_margin } from "../../model/check_text.js";
import { h, svg } from "../dom.js";

const DECADES_BELOW = 8;
const DECADES_ABOVE = 4;
const WIDTH = 90;
const LIMIT = (WIDTH * DECADES_BELOW) / (DECADES_BELOW + DECADES_ABOVE);

const CLASSES = { pass: "within", fail: "beyond", error: "beyond", limit: "known", refuted: "refuted" };

function length_of(margin) {
  if (margin === 0) return 0;
  const decades = Math.min(DECADES_ABOVE, Math.max(-DECADES_BELOW, Math.log10(margin)));
  return Math.max(1.5, ((decades + DECADES_BELOW) / (DECADES_BELOW + DECADES_ABOVE)) * WIDTH);
}

/** `verdict` decides the colour where it is known: it may have been judged more strictly. */
export function margin_bar(margin, with_text = true, verdict = margin <= 1 ? "pass" : "fail") {
  const bar = svg(
    "svg",
    {
      class: `margin ${CLASSES[verdict] ?? "undecided"}`,
      viewBox: `0 0 ${WIDTH} 12`,
      width: WIDTH,
      height: 12,
      "aria-hidden": "true",
      focusable: "false",
    },
    svg("rect", { class: "track", x: 0, y: 4, width: WIDTH, height: 4 }),
    svg("rect", { class: "value", x: 0, y: 3, width: length_of(margin), height: 6 }),
    svg("rect", { class: "limit", x: LIMIT - 0.75, y: 0, width: 1.5, height: 12 }),
  );
  return h(
    "span",
    { class: "margin-cell", title: margin_text(margin) },
    bar,
    with_text && h("span", { class: "margin-text" }, short_margin(margin)),
  );
}
