// SPDX-License-Identifier: GPL-3.0-or-later
// A shape for each verdict, so that none rests on its colour: disc, triangle,
// triangle upside down, saltire, diamond, square, ring.
import { VERDICT_WORDS } from "../../model/verdict.js";
import { h, svg } from "../dom.js";

export const PATHS = {
  pass: "M8 1.5a6.5 6.5 0 1 1 0 13a6.5 6.5 0 1 1 0-13zM4.6 8.2l2.5 2.6 4.4-5-1.2-1-3.3 3.8-1.3-1.5z",
  fail: "M8 1l7.4 13.6H.6zM7.1 5.8l.3 4.6h1.2l.3-4.6zM7.2 11.4v1.6h1.6v-1.6z",
  "expected-shortfall":
    "M8 15L.6 1.400h14.800zM7.200 4v5h1.600V4zM7.200 10.200v1.600h1.600v-1.600z",
  refuted:
    "M3.200 1.400L8 6.200l4.800-4.800 1.800 1.800L9.800 8l4.800 4.800-1.800 1.800L8 9.800l-4.800 4.800-1.800-1.800L6.200 8 1.400 3.200z",
  error:
    "M8 .6L15.4 8 8 15.4.6 8zM5.9 4.9l-1 1L7 8l-2.100 2.100 1 1L8 9l2.100 2.100 1-1L9 8l2.100-2.100-1-1L8 7z",
  "for-information": "M2.500 2.500h11v11h-11zM4.500 7.200v1.600h7V7.200z",
  "not-applicable":
    "M8 1.500a6.500 6.500 0 1 1 0 13a6.500 6.500 0 1 1 0-13zM8 3.300a4.700 4.700 0 1 0 0 9.400a4.700 4.700 0 1 0 0-9.400z",
};

/** The bare shape, for places where the word stands beside it. */
export const glyph = (verdict, size = 16) =>
  svg(
    "svg",
    {
      class: `glyph ${class_of(verdict)}`,
      viewBox: "0 0 16 16",
      width: size,
      height: size,
      "aria-hidden": "true",
      focusable: "false",
    },
    svg("path", {
      d: PATHS[verdict] ?? PATHS["not-applicable"],
      "fill-rule": "evenodd",
      fill: "currentColor",
    }),
  );

const class_of = (verdict) => `verdict-${verdict in PATHS ? verdict : "not-applicable"}`;

/** Shape and word. */
export const verdict_mark = (verdict, size = 16) =>
  h(
    "span",
    { class: `verdict ${class_of(verdict)}` },
    glyph(verdict, size),
    h("span", { class: "word", "data-term": verdict }, VERDICT_WORDS[verdict] ?? verdict),
  );
