// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of line drawings in px, y downwards.
import { chord, hatching } from "./outline.js";
import { e } from "./tree.js";

const px = (x) => Number(x.toFixed(1));
const points_text = (points) => points.map((point) => point.map(px).join(",")).join(" ");

export const line = ([x1, y1], [x2, y2], name = "stroke") =>
  e("line", { x1: px(x1), y1: px(y1), x2: px(x2), y2: px(y2), class: name });

export const polygon = (points, name = "body") =>
  e("polygon", { points: points_text(points), class: name });

export const circle = ([x, y], radius, name = "body") =>
  e("circle", { cx: px(x), cy: px(y), r: px(radius), class: name });

export const label = ([x, y], text, { anchor = "middle", name = "label" } = {}) =>
  e("text", { x: px(x), y: px(y), "text-anchor": anchor, class: name }, text);

export const plus = ([x, y], [dx, dy], factor = 1) => [x + factor * dx, y + factor * dy];
const length_of = ([x, y]) => Math.hypot(x, y) || 1;
export const unit_of = (way) => way.map((x) => x / length_of(way));

function head(tip, way, name, size = 7) {
  const [x, y] = unit_of(way);
  return polygon(
    [
      tip,
      [tip[0] - size * x - 0.45 * size * y, tip[1] - size * y + 0.45 * size * x],
      [tip[0] - size * x + 0.45 * size * y, tip[1] - size * y - 0.45 * size * x],
    ],
    `${name}-head`,
  );
}

/** An arrow from a point by (dx, dy). */
export function arrow(from, way, name) {
  const tip = plus(from, way);
  return [line(from, plus(tip, unit_of(way), -5), name), head(tip, way, name)];
}

/** A turning arrow about a point, clockwise or against it; with less `tall` seen from the side. */
export function turning_arrow([x, y], radius, clockwise, name, tall = radius) {
  const tip = [x + (clockwise ? radius : -radius), y];
  const start = [x + (clockwise ? -radius : radius), y];
  return [
    e("path", {
      d: `M${px(start[0])} ${px(start[1])}A${px(radius)} ${px(tall)} 0 0 ${clockwise ? 1 : 0} ${px(tip[0])} ${px(tip[1])}`,
      class: `${name} open`,
    }),
    head(plus(tip, [0, 4]), [0, 1], name),
  ];
}

/** A half-space's face: a line in the box [left, top, right, bottom] with hatching on its inner side. */
export function face(point, normal, [left, top, right, bottom]) {
  const box = [
    [left, top],
    [right, top],
    [right, bottom],
    [left, bottom],
  ];
  const way = [-normal[1], normal[0]];
  const ends = chord(box, point, way);
  if (!ends) return [];
  const length = Math.hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
  const ticks = [];
  for (let at = 5; at < length - 2; at += 9) {
    const from = plus(ends[0], way, at);
    ticks.push(line(from, plus(plus(from, normal, -6), way, -5), "hatch"));
  }
  return [...ticks, line(ends[0], ends[1], "ground")];
}

/** Hatching over a convex polygon. */
export const hatched = (points, spacing = 6) =>
  hatching(points, spacing).map(([a, b]) => line(a, b, "hatch held"));

/** A spring from a to b. */
export function spring(a, b) {
  const way = [b[0] - a[0], b[1] - a[1]];
  const [ux, uy] = unit_of(way);
  const length = Math.hypot(...way);
  const turns = Math.max(3, Math.min(9, Math.round(length / 12)));
  const at = (part, side) => [
    a[0] + part * way[0] - 5 * side * uy,
    a[1] + part * way[1] + 5 * side * ux,
  ];
  const points = [a, at(0.12, 0)];
  for (let i = 0; i < 2 * turns; ++i)
    points.push(at(0.12 + (0.76 * (i + 0.5)) / (2 * turns), i % 2 ? -1 : 1));
  points.push(at(0.88, 0), b);
  return [e("polyline", { points: points_text(points), class: "spring" }), circle(b, 3, "anchor")];
}

/** A dimension line between a and b, moved out by `offset` px along `out`, with its number. */
export function dimension(a, b, out, offset, text) {
  const way = unit_of([b[0] - a[0], b[1] - a[1]]);
  const [from, to] = [plus(a, out, offset), plus(b, out, offset)];
  const middle = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  const narrow = Math.hypot(to[0] - from[0], to[1] - from[1]) < 18;
  const place = plus(middle, out, 9);
  const steep = Math.abs(out[0]) > 0.5;
  return [
    line(plus(a, out, 3), plus(from, out, 3), "thin"),
    line(plus(b, out, 3), plus(to, out, 3), "thin"),
    narrow
      ? line(from, to, "thin")
      : [
          line(from, to, "thin"),
          head(to, way, "thin", 5),
          head(from, [-way[0], -way[1]], "thin", 5),
        ],
    label([place[0], place[1] + 4], text, {
      anchor: steep ? (out[0] > 0 ? "start" : "end") : "middle",
    }),
  ];
}

/** An angle between the horizontal and the way down a slope, at its foot. */
export function angle_mark(corner, angle, radius, text) {
  const ends = [
    [corner[0] - radius, corner[1]],
    [corner[0] - radius * Math.cos(angle), corner[1] - radius * Math.sin(angle)],
  ];
  return [
    line(corner, [corner[0] - 1.35 * radius, corner[1]], "thin dashed"),
    e("path", {
      d: `M${px(ends[0][0])} ${px(ends[0][1])}A${px(radius)} ${px(radius)} 0 0 1 ${px(ends[1][0])} ${px(ends[1][1])}`,
      class: "thin open",
    }),
    label([corner[0] - 1.4 * radius - 4, corner[1] + 9], text, { anchor: "end" }),
  ];
}
