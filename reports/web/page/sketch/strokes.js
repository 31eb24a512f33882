// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of line drawings, 220 × 130, y downwards.
import { svg } from "../dom.js";

export const WIDTH = 220;
export const HEIGHT = 130;

export const line = (x1, y1, x2, y2, name = "stroke") =>
  svg("line", { x1, y1, x2, y2, class: name });

export const polygon = (points, name = "body") =>
  svg("polygon", { points: points.map((point) => point.join(",")).join(" "), class: name });

export const circle = (cx, cy, r, name = "body") => svg("circle", { cx, cy, r, class: name });

export const label = (x, y, text, anchor = "middle") =>
  svg("text", { x, y, "text-anchor": anchor, class: "label" }, text);

/** Ground: a line with hatching below, from (x1, y1) to (x2, y2). */
export function ground(x1, y1, x2, y2) {
  const length = Math.hypot(x2 - x1, y2 - y1);
  const [dx, dy] = [(x2 - x1) / length, (y2 - y1) / length];
  const hatches = [];
  for (let along = 4; along < length; along += 9) {
    const [x, y] = [x1 + dx * along, y1 + dy * along];
    hatches.push(line(x, y, x - 5 * dx - 5 * dy, y - 5 * dy + 5 * dx, "hatch"));
  }
  return [line(x1, y1, x2, y2, "ground"), ...hatches];
}

/** An arrow from (x, y) by (dx, dy). */
export function arrow(x, y, dx, dy, name = "arrow") {
  const length = Math.hypot(dx, dy) || 1;
  const [ux, uy] = [dx / length, dy / length];
  const [tx, ty] = [x + dx, y + dy];
  const head = [
    [tx, ty],
    [tx - 7 * ux - 3.5 * uy, ty - 7 * uy + 3.5 * ux],
    [tx - 7 * ux + 3.5 * uy, ty - 7 * uy - 3.5 * ux],
  ];
  return [line(x, y, tx - 4 * ux, ty - 4 * uy, name), polygon(head, `${name}-head`)];
}

/** A box of width w and height h that stands on (x, y), its base turned by `angle` (rad, upwards to the left). */
export function box_on(x, y, angle, w, h) {
  const [ux, uy] = [Math.cos(angle), Math.sin(angle)];
  const at = (along, up) => [x + along * ux + up * uy, y + along * uy - up * ux];
  return {
    corners: [at(-w / 2, 0), at(w / 2, 0), at(w / 2, h), at(-w / 2, h)],
    centre: at(0, h / 2),
    at,
  };
}
