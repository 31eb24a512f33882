// SPDX-License-Identifier: GPL-3.0-or-later
// From which side a problem is drawn: gravity's end points down, the slope falls to the right, and what
// moves, pushes or lies side by side does so across the picture.
import { first_of, last_of, slope_of, up_of } from "../model/problem.js";
import {
  across,
  add,
  cross,
  dot,
  scaled,
  size_of,
  subtract,
  turned,
  unit,
} from "../model/vector.js";

const RIGHT = [1, 0.37, 0.21]; // what points this way stands to the right

/** Corners of a body in the world, at the start: of its box, or of that around it. */
export function corners_of({ shape, position, rotation }) {
  const [low, high] = bounds_of(shape);
  return Array.from({ length: 8 }, (_, i) =>
    add(
      position,
      turned(
        rotation,
        [0, 1, 2].map((axis) => ((i >> axis) & 1 ? high : low)[axis]),
      ),
    ),
  );
}

export function bounds_of({ kind, size, radius, low, high }) {
  if (kind === "box") return [scaled(size, -0.5), scaled(size, 0.5)];
  if (kind === "ball")
    return [
      [-radius, -radius, -radius],
      [radius, radius, radius],
    ];
  return kind === "mesh"
    ? [low, high]
    : [
        [0, 0, 0],
        [0, 0, 0],
      ];
}

// The parts of some vectors across `up`, as units, of those that are not small against the whole.
const parts_across = (vectors, up) =>
  vectors
    .map((vector) => ({ vector, level: across(vector, up) }))
    .filter(({ vector, level }) => size_of(level) > 0.1 * size_of(vector))
    .map(({ level }) => unit(level));

const HIDDEN = 0.6; // of a body's picture, by another's

// How many bodies a picture hides behind others, or others behind them.
function hidden_in(boxes, right, up) {
  const flat = boxes.map((corners) => {
    const [xs, ys] = [right, up].map((axis) => corners.map((corner) => dot(corner, axis)));
    return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
  });
  const area = ([left, low, end, high]) => Math.max(0, end - left) * Math.max(0, high - low);
  let count = 0;
  flat.forEach((a, i) => {
    for (const b of flat.slice(i + 1)) {
      const both = area([
        Math.max(a[0], b[0]),
        Math.max(a[1], b[1]),
        Math.min(a[2], b[2]),
        Math.min(a[3], b[3]),
      ]);
      if (both > HIDDEN * Math.min(area(a), area(b))) ++count;
    }
  });
  return count;
}

// Of the world's axes that along which the bodies reach farthest.
function longest_axis(problem, up) {
  const corners = problem.bodies.flatMap(corners_of);
  let best = null;
  for (const axis of [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ]) {
    const level = across(axis, up);
    if (size_of(level) < 0.5) continue;
    const places = corners.map((corner) => dot(corner, unit(level)));
    const reach = places.reduce((a, b) => Math.max(a, b)) - places.reduce((a, b) => Math.min(a, b));
    if (!best || reach > 1.001 * best.reach) best = { reach, way: unit(level) };
  }
  return best.way;
}

const to_the_right = (way) => (dot(way, RIGHT) < 0 ? scaled(way, -1) : way);

const way_of_motion = (motion) => subtract(last_of(motion), first_of(motion));

// Ways across the picture, the most telling first.
const candidates = (problem, up) => [
  ...parts_across(
    [
      ...problem.obstacles.map(({ normal }) => normal),
      ...problem.springs.map(({ axis }) => axis),
      ...problem.loads.map(({ force }) => last_of(force)),
      ...problem.bodies.map(({ velocity }) => velocity),
      ...problem.bodies.map(({ motion }) => way_of_motion(motion)),
      ...problem.obstacles.map(({ motion }) => way_of_motion(motion)),
    ],
    up,
  ),
  longest_axis(problem, up),
];

const MOST_LOOKED_AT = 60; // bodies: of more none can be told apart anyway
const MOST_WAYS = 8;

// The first of those that hide fewest bodies.
function best_of(ways, { bodies }, up) {
  const boxes = bodies.slice(0, MOST_LOOKED_AT).map(corners_of);
  let best = null;
  for (const way of [...ways.slice(0, MOST_WAYS), ways.at(-1)]) {
    const hidden = hidden_in(boxes, way, up);
    if (!best || hidden < best.hidden) best = { way, hidden };
  }
  return to_the_right(best.way);
}

/** {up, right, near: unit vectors, slope}: `near` points to who looks at it. */
export function view_of(problem) {
  const up = up_of(problem);
  const slope = slope_of(problem);
  const right = slope
    ? unit(across(slope.normal, up))
    : best_of(candidates(problem, up), problem, up);
  return { up, right, near: cross(right, up), slope };
}
