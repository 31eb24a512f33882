// SPDX-License-Identifier: GPL-3.0-or-later
import { arrow, box_on, HEIGHT, polygon, WIDTH } from "./strokes.js";

export const matches = (name) => /collision|collide|appendix-a|impact/i.test(name);

/** Two free boxes that meet, one of them turned. */
export function draw() {
  const [x, y] = [WIDTH / 2, HEIGHT / 2 + 17];
  const lower = box_on(x - 27, y, 0, 34, 34);
  const upper = box_on(x + 26, y - 2, 0.3, 34, 34);
  return [
    polygon(lower.corners),
    polygon(upper.corners),
    arrow(x - 84, y - 17, 34, 0, "motion"),
    arrow(x + 88, y - 20, -34, 0, "motion"),
  ];
}
