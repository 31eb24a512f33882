// SPDX-License-Identifier: GPL-3.0-or-later
import { arrow, circle, HEIGHT, line, WIDTH } from "./strokes.js";

export const matches = () => true;

/** Anything else: two bodies that touch, with the forces between them. */
export function draw() {
  const [x, y] = [WIDTH / 2, HEIGHT / 2];
  return [
    circle(x - 34, y, 34),
    circle(x + 34, y, 34),
    line(x, y - 46, x, y + 46, "thin"),
    arrow(x, y, 44, 0, "force"),
    arrow(x, y, 0, -32, "friction"),
  ];
}
