// SPDX-License-Identifier: GPL-3.0-or-later
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
} from "three";
import { body_colour } from "../plots/palette.js";

/** The surfaces: {group, show(positions of all bodies), positions()}. */
export function make_bodies(bodies, colours) {
  const group = new Group();
  const parts = bodies.map((body, i) => {
    const geometry = new BufferGeometry();
    const positions = new BufferAttribute(new Float32Array(3 * body.vertices), 3);
    positions.setUsage(DynamicDrawUsage);
    geometry.setAttribute("position", positions);
    geometry.setIndex(new BufferAttribute(body.triangles, 1));
    const faces = new MeshLambertMaterial({
      color: colours[body_colour(i)],
      flatShading: true,
      side: DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    const edges = new MeshBasicMaterial({
      color: colours.$ink,
      wireframe: true,
      transparent: true,
      opacity: 0.22,
    });
    for (const material of [faces, edges]) {
      const mesh = new Mesh(geometry, material);
      mesh.frustumCulled = false;
      group.add(mesh);
    }
    return { positions, size: 3 * body.vertices };
  });
  return {
    group,
    show(positions) {
      let start = 0;
      for (const part of parts) {
        part.positions.array.set(positions.subarray(start, start + part.size));
        part.positions.needsUpdate = true;
        start += part.size;
      }
    },
    positions: () => parts.flatMap((part) => [...part.positions.array]),
  };
}
