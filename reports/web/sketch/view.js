// SPDX-License-Identifier: GPL-3.0-or-later
// From which side a problem is drawn: gravity's end points down, the slope falls to the right, and what
// moves, pushes or lies side by side does so across the picture.
import { first_of, last_of, slope_of, up_of } from "../model/problem.js";
import { across, add, cross, dot, scaled, size_of, subtract, turned, unit } from "../model/vector.js";

const RIGHT = [1, 0.37, 0.21]; // what points this way stands to the right

/** Corners of a body in the world, at the start: of its box, or of that around it. */
export function corners_of({ shape, position, rotation }) {
  const [low, high] = bounds_of(shape);
  return Array.from({ length: 8 }, (_, i) =>
    add(position, turned(rotation, [0, 1, 2].map((axis) => ((i >> axis) & 1 ? high : low)[axis]))),
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

// The first of some vectors whose part across `up` is not small against itself.
function first_across(vectors, up) {
  for (const vector of vectors) {
    const level = across(vector, up);
    if (size_of(level) > 0.1 * size_of(vector) && size_of(vector) > 0) return unit(level);
  }
  return null;
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

/** {up, right, near: unit vectors, slope}: `near` points to who looks at it. */
export function view_of(problem) {
  const up = up_of(problem);
  const slope = slope_of(problem);
  const moving = first_across(
    [
      ...problem.obstacles.map(({ normal }) => normal),
      ...problem.springs.map(({ axis }) => axis),
      ...problem.loads.map(({ force }) => last_of(force)),
      ...problem.bodies.map(({ velocity }) => velocity),
      ...problem.bodies.map(({ motion }) => way_of_motion(motion)),
      ...problem.obstacles.map(({ motion }) => way_of_motion(motion)),
    ],
    up,
  );
  const right = slope
    ? unit(across(slope.normal, up))
    : to_the_right(moving ?? longest_axis(problem, up));
  return { up, right, near: cross(right, up), slope };
}
