// SPDX-License-Identifier: GPL-3.0-or-later
import { arrow, circle, ground, HEIGHT, line, polygon, WIDTH } from "./strokes.js";

export const matches = (name) => /half-space|drop|bounce|free-fall/i.test(name);

/** A body above, or on, level ground. */
export function draw(name) {
  const [middle, base] = [WIDTH / 2, HEIGHT - 22];
  const resting = /rest/.test(name);
  const lift = resting ? 0 : 44;
  const point = /bounce|free-fall|point/.test(name);
  const body = point
    ? circle(middle, base - lift - 8, 8)
    : polygon([
        [middle - 28, base - lift],
        [middle + 28, base - lift],
        [middle + 28, base - lift - 34],
        [middle - 28, base - lift - 34],
      ]);
  return [
    ground(28, base, WIDTH - 28, base),
    body,
    resting
      ? [-20, 20].map((x) => arrow(middle + x, base, 0, -24, "force"))
      : [
          arrow(middle, base - lift - 8, 0, 34, "motion"),
          line(middle - 44, base, middle - 44, base - lift, "thin"),
        ],
    arrow(middle, base - lift - 17, 0, resting ? 30 : 0.1, resting ? "weight" : "none"),
  ];
}
