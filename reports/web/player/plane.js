// SPDX-License-Identifier: GPL-3.0-or-later
import {
  BufferGeometry,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Quaternion,
  Vector3,
} from "three";

const CELLS = 12;

/** A fixed half-space: the piece of its face below the scene, with a grid. */
export function make_plane({ point, normal }, centre, radius, colours) {
  const group = new Group();
  const size = 3.2 * radius;
  const up = new Vector3(...normal).normalize();
  const foot = centre
    .clone()
    .addScaledVector(up, -up.dot(centre.clone().sub(new Vector3(...point))));
  group.position.copy(foot);
  group.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), up));
  group.add(
    new Mesh(
      new PlaneGeometry(size, size),
      new MeshBasicMaterial({
        color: colours.$grid,
        transparent: true,
        opacity: 0.45,
        side: DoubleSide,
        depthWrite: false,
      }),
    ),
  );
  const lines = [];
  for (let i = 0; i <= CELLS; ++i) {
    const at = (i / CELLS - 0.5) * size;
    lines.push(at, -size / 2, 0, at, size / 2, 0, -size / 2, at, 0, size / 2, at, 0);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(lines, 3));
  group.add(
    new LineSegments(
      geometry,
      new LineBasicMaterial({ color: colours.$axis, transparent: true, opacity: 0.5 }),
    ),
  );
  return group;
}
