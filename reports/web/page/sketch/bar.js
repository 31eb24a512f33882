// SPDX-License-Identifier: GPL-3.0-or-later
import { arrow, ground, HEIGHT, polygon, WIDTH } from "./strokes.js";

export const matches = (name) => /^bar/i.test(name);

/** A long bar on a bed, pushed at its held end; friction grows from there. */
export function draw() {
  const base = HEIGHT - 40;
  const [left, right] = [52, WIDTH - 16];
  const corners = [
    [left, base],
    [right, base],
    [right, base - 14],
    [left, base - 14],
  ];
  return [
    ground(12, base, WIDTH - 6, base),
    polygon(corners),
    arrow(left - 36, base - 7, 34, 0, "motion"),
    [0, 24, 48].map((along) => arrow(left + 26 + along, base + 12, -20, 0, "friction")),
    arrow(WIDTH / 2 + 40, base - 7, 0, 34, "weight"),
  ];
}
