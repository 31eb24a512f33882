// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts as marks, sticking ones round, slipping ones pointed; forces as arrows. They are drawn over
// the bodies: most contacts lie under one.
import {
  ConeGeometry,
  CylinderGeometry,
  DynamicDrawUsage,
  Group,
  InstancedMesh,
  Matrix4,
  MeshLambertMaterial,
  OctahedronGeometry,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";

const MOST = 4096; // contacts shown at a time
const UP = new Vector3(0, 1, 0); // the axis of three's cones and cylinders

const SEE_THROUGH = 0.75; // what lies behind a mark stays seen

function instances(geometry, colour, order) {
  const mesh = new InstancedMesh(
    geometry,
    new MeshLambertMaterial({
      color: colour,
      depthTest: false,
      transparent: true,
      opacity: SEE_THROUGH,
    }),
    MOST,
  );
  mesh.renderOrder = order;
  mesh.instanceMatrix.setUsage(DynamicDrawUsage);
  mesh.frustumCulled = false;
  mesh.count = 0;
  return mesh;
}

// Arrows of one colour: unit shafts and heads, placed and scaled.
function make_arrows(radius, colour) {
  const thickness = 0.006 * radius;
  const shafts = instances(
    new CylinderGeometry(thickness, thickness, 1, 8).translate(0, 0.5, 0),
    colour,
    1,
  );
  const heads = instances(
    new ConeGeometry(3 * thickness, 8 * thickness, 12).translate(0, -4 * thickness, 0),
    colour,
    1,
  );
  const [matrix, turn, along, tip, scale] = [
    new Matrix4(),
    new Quaternion(),
    new Vector3(),
    new Vector3(),
    new Vector3(),
  ];
  return {
    meshes: [shafts, heads],
    start: () => (shafts.count = heads.count = 0),
    add(from, vector) {
      const length = vector.length();
      if (length < 4 * thickness || shafts.count >= MOST) return;
      turn.setFromUnitVectors(UP, along.copy(vector).divideScalar(length));
      shafts.setMatrixAt(
        shafts.count++,
        matrix.compose(from, turn, scale.set(1, Math.max(1e-9, length - 6 * thickness), 1)),
      );
      heads.setMatrixAt(
        heads.count++,
        matrix.compose(tip.copy(from).add(vector), turn, scale.set(1, 1, 1)),
      );
    },
    finish() {
      shafts.instanceMatrix.needsUpdate = heads.instanceMatrix.needsUpdate = true;
    },
  };
}

/** {group, show(contacts), set(forces, marks)}; `force` (N) gets an arrow of ordinary length. */
export function make_contacts(radius, force, colours) {
  const group = new Group();
  const size = 0.014 * radius;
  const sticking = instances(new SphereGeometry(size, 16, 12), colours.$s0, 2);
  const slipping = instances(new OctahedronGeometry(1.35 * size), colours.$s1, 2);
  const normals = make_arrows(radius, colours.$ink);
  const frictions = make_arrows(radius, colours.$s3);
  const marks = [sticking, slipping];
  const arrows = [...normals.meshes, ...frictions.meshes];
  group.add(...marks, ...arrows);
  const metres_per_newton = force > 0 ? (0.25 * radius) / force : 0;
  const [matrix, at, vector] = [new Matrix4(), new Vector3(), new Vector3()];
  const scaled = (triple) =>
    vector
      .set(...triple)
      .multiplyScalar(metres_per_newton)
      .clampLength(0, 0.6 * radius);

  return {
    group,
    show(contacts) {
      sticking.count = slipping.count = 0;
      normals.start();
      frictions.start();
      for (const contact of contacts.slice(0, MOST)) {
        at.set(...contact.position);
        const mark = contact.sticks ? sticking : slipping;
        mark.setMatrixAt(mark.count++, matrix.makeTranslation(at));
        normals.add(at, scaled(contact.normal_force));
        frictions.add(at, scaled(contact.friction_force));
      }
      sticking.instanceMatrix.needsUpdate = slipping.instanceMatrix.needsUpdate = true;
      normals.finish();
      frictions.finish();
    },
    set(forces, contacts) {
      for (const mesh of arrows) mesh.visible = forces;
      for (const mesh of marks) mesh.visible = contacts;
    },
  };
}
