// SPDX-License-Identifier: GPL-3.0-or-later
import { arrow, circle, HEIGHT, line, WIDTH } from "./strokes.js";
import { svg } from "../dom.js";

export const matches = (name) => /membrane|sheet|cloth|basket|net/i.test(name);

/** A ball that a sheet, or a basket, carries. */
export function draw(name) {
  const [x, y] = [WIDTH / 2, HEIGHT / 2];
  const basket = /basket/.test(name);
  const sag = basket ? 78 : 44;
  return [
    svg("path", {
      d: `M34 ${y - 22} C 80 ${y - 22 + sag}, ${WIDTH - 80} ${y - 22 + sag}, ${WIDTH - 34} ${y - 22}`,
      class: "sheet",
    }),
    line(34, y - 34, 34, y - 10, "ground"),
    line(WIDTH - 34, y - 34, WIDTH - 34, y - 10, "ground"),
    circle(x, y - 22 + 0.75 * sag - 20, 19),
    arrow(x, y - 22 + 0.75 * sag - 20, 0, 32, "weight"),
  ];
}
