// SPDX-License-Identifier: GPL-3.0-or-later
// A line drawing of a case's scene, chosen by its name: for cases without a recording.
import { h, svg } from "../dom.js";
import * as bar from "./bar.js";
import * as clamp from "./clamp.js";
import * as collision from "./collision.js";
import * as drop from "./drop.js";
import * as incline from "./incline.js";
import * as pyramid from "./pyramid.js";
import * as sheet from "./sheet.js";
import { HEIGHT, WIDTH } from "./strokes.js";

const KINDS = [bar, clamp, collision, pyramid, sheet, incline, drop];

const KEY = [
  ["weight", "weight"],
  ["force", "normal force"],
  ["friction", "friction"],
  ["motion", "motion"],
];

/** Null for a case of a kind that has none. */
export function sketch(case_name) {
  const kind = KINDS.find(({ matches }) => matches(case_name));
  if (!kind) return null;
  const drawing = svg(
    "svg",
    {
      class: "sketch",
      viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
      role: "img",
      "aria-label": `Sketch of the scene of ${case_name}`,
    },
    kind.draw(case_name),
  );
  const used = KEY.filter(([name]) => drawing.querySelector(`.${name}`));
  return h(
    "figure",
    { class: "scene" },
    drawing,
    h(
      "figcaption",
      {},
      "Sketch, not to scale",
      used.map(([name, word], i) => [
        i > 0 ? ", " : ": ",
        h("span", { class: `key key-${name}` }, word),
      ]),
      ".",
    ),
  );
}
