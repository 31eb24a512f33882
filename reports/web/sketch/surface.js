// SPDX-License-Identifier: GPL-3.0-or-later
// A body's real surface, as a recording has it, seen from the side: its silhouette and its sharp edges.
import { cross, dot, size_of, subtract } from "../model/vector.js";
import { e } from "./tree.js";

const SHARP = Math.cos(0.35); // of the angle between two faces' normals
const MOST_TRIANGLES = 3000;

const px = (x) => Number(x.toFixed(1));

/** `at(point)` gives px, `near` points to who looks at it. */
export function surface_strokes({ vertices, triangles }, at, near) {
  const flat = vertices.map(at);
  const faces = [];
  for (let i = 0; i + 2 < triangles.length && faces.length < MOST_TRIANGLES; i += 3) {
    const places = [triangles[i], triangles[i + 1], triangles[i + 2]];
    const [a, b, c] = places.map((place) => vertices[place]);
    const normal = cross(subtract(b, a), subtract(c, a));
    const size = size_of(normal) || 1;
    faces.push({ places, normal: normal.map((x) => x / size) });
  }
  const edges = new Map();
  for (const face of faces)
    face.places.forEach((a, i) => {
      const b = face.places[(i + 1) % 3];
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      edges.set(key, [...(edges.get(key) ?? []), face]);
    });
  const seen = ({ normal }) => dot(normal, near) > 1e-6;
  const path = (places) => places.map((place) => flat[place].map(px).join(" ")).join("L");
  const fill = faces.filter(seen).map(({ places }) => `M${path(places)}Z`);
  const strokes = [...edges]
    .filter(([, [first, second]]) => {
      if (!second) return true;
      if (!seen(first) && !seen(second)) return false;
      return seen(first) !== seen(second) || dot(first.normal, second.normal) < SHARP;
    })
    .map(([key]) => `M${path(key.split(" "))}`);
  return [
    e("path", { d: fill.join(""), class: "body fill" }),
    e("path", { d: strokes.join(""), class: "body edges" }),
  ];
}
