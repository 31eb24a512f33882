// SPDX-License-Identifier: GPL-3.0-or-later
// A configuration's mark, in the colour and shape that it has in every plot.
import { configuration_styles } from "../../plots/configuration_style.js";
import { BAR } from "../../plots/palette.js";
import { svg } from "../dom.js";

// As Vega draws these shapes, in a square from −1 to 1.
export const SHAPES = {
  circle: "M1,0A1,1,0,1,1,-1,0A1,1,0,1,1,1,0Z",
  square: "M-0.9,-0.9H0.9V0.9H-0.9Z",
  "triangle-up": "M0,-0.9L1,0.8H-1Z",
  diamond: "M0,-1.2L0.9,0L0,1.2L-0.9,0Z",
  cross: "M-0.35,-1H0.35V-0.35H1V0.35H0.35V1H-0.35V0.35H-1V-0.35H-0.35Z",
  "triangle-down": "M0,0.9L1,-0.8H-1Z",
  [BAR]: BAR,
};

export function style_mark(name, size = 11) {
  const { colour, shape } = configuration_styles([name]).get(name);
  return svg(
    "svg",
    {
      class: `style-mark series-${colour.slice(1)}`,
      viewBox: "-1.3 -1.3 2.6 2.6",
      width: size,
      height: size,
      "aria-hidden": "true",
      focusable: "false",
    },
    svg("path", { d: SHAPES[shape] ?? SHAPES.circle, fill: "currentColor" }),
  );
}
