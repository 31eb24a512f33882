// SPDX-License-Identifier: GPL-3.0-or-later
import { arrow, HEIGHT, polygon, WIDTH } from "./strokes.js";

export const matches = (name) => /clamp|squeez|grip|painlev|-row\b/i.test(name);

/** A box held between two jaws by friction alone. */
export function draw() {
  const [x, y] = [WIDTH / 2, HEIGHT / 2 - 6];
  const rectangle = (left, top, width, height) => [
    [left, top],
    [left + width, top],
    [left + width, top + height],
    [left, top + height],
  ];
  return [
    polygon(rectangle(x - 22, y - 22, 44, 44)),
    polygon(rectangle(x - 46, y - 32, 24, 64), "jaw"),
    polygon(rectangle(x + 22, y - 32, 24, 64), "jaw"),
    arrow(x - 78, y, 30, 0, "force"),
    arrow(x + 78, y, -30, 0, "force"),
    arrow(x, y, 0, 48, "weight"),
    arrow(x - 18, y + 14, 0, -32, "friction"),
    arrow(x + 18, y + 14, 0, -32, "friction"),
  ];
}
