// SPDX-License-Identifier: GPL-3.0-or-later
import { arrow, circle, ground, HEIGHT, polygon, WIDTH } from "./strokes.js";

export const matches = (name) => /pyramid|stack|four-ball|balls|wall|arch/i.test(name);

/** Balls or boxes that rest on each other. */
export function draw(name) {
  const [x, base] = [WIDTH / 2, HEIGHT - 20];
  const boxes = /box|wall|stack/.test(name);
  const bodies = boxes
    ? [0, 1, 2].flatMap((row) =>
        Array.from({ length: 3 - row }, (_, i) => {
          const left = x - 21 * (3 - row) + 42 * i;
          const top = base - 28 * (row + 1);
          return polygon([
            [left + 1, top + 28],
            [left + 41, top + 28],
            [left + 41, top],
            [left + 1, top],
          ]);
        }),
      )
    : [
        circle(x - 24, base - 24, 24),
        circle(x + 24, base - 24, 24),
        circle(x, base - 24 - 41.6, 24),
        circle(x, base - 18, 18, "body far"),
      ];
  return [
    ground(22, base, WIDTH - 22, base),
    boxes ? bodies : [bodies[3], ...bodies.slice(0, 3)],
    boxes
      ? null
      : [arrow(x - 46, base - 4, 24, 0, "friction"), arrow(x + 46, base - 4, -24, 0, "friction")],
  ];
}
