// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of a problem's meshes at the start, from a recording of it: records have only their boxes.
import { add, turned } from "./vector.js";

const NEAR = 0.02; // of a body's size: a recording of another simulation has its bodies elsewhere

function reach_of(points) {
  const low = [0, 1, 2].map((axis) => Math.min(...points.map((point) => point[axis])));
  const high = [0, 1, 2].map((axis) => Math.max(...points.map((point) => point[axis])));
  return { low, high, size: Math.max(...high.map((x, axis) => x - low[axis])) };
}

// Where the vertices lie inside the box that the problem gives, and fill it.
function fits({ shape, position, rotation }, vertices) {
  const back = [rotation[0], ...rotation.slice(1).map((x) => 0 - x)];
  const own = vertices.map((vertex) =>
    turned(
      back,
      add(
        vertex,
        position.map((x) => 0 - x),
      ),
    ),
  );
  const { low, high, size } = reach_of(own);
  return [0, 1, 2].every(
    (axis) =>
      Math.abs(low[axis] - shape.low[axis]) <= NEAR * size &&
      Math.abs(high[axis] - shape.high[axis]) <= NEAR * size,
  );
}

/** Map from the place of a mesh to {vertices: [[x, y, z]], triangles}; `recording` as decode_frames() gives it. */
export function surfaces_of(problem, recording) {
  const surfaces = new Map();
  if (recording.bodies.length !== problem.bodies.length) return surfaces;
  const { positions } = recording.frame(0);
  let first = 0;
  recording.bodies.forEach(({ name, vertices: count, triangles }, place) => {
    const body = problem.bodies[place];
    const vertices = Array.from({ length: count }, (_, i) => [
      ...positions.subarray(3 * (first + i), 3 * (first + i) + 3),
    ]);
    first += count;
    if (body.shape.kind === "mesh" && body.name === name && fits(body, vertices))
      surfaces.set(place, { vertices, triangles });
  });
  return surfaces;
}
