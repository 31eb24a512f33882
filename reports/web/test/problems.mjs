// SPDX-License-Identifier: GPL-3.0-or-later
// Problems as records tell them (validation/engine/protocol/README.md), for tests.

const still = { time: [], value: [] };
const constant = (value) => ({ time: [0], value: [value] });

export const body = (change = {}) => ({
  name: "box",
  shape: { box: { size: [0.2, 0.2, 0.1] } },
  mass: 1,
  elasticity: { youngs_modulus: 5e5, poisson_ratio: 0.3, damping_time: 0.001 },
  position: [0, 0, 0.05],
  rotation: [1, 0, 0, 0],
  velocity: [0, 0, 0],
  angular_velocity: [0, 0, 0],
  motion: still,
  self_collision: false,
  must_deform: false,
  ...change,
});

export const obstacle = (change = {}) => ({
  name: "plane",
  point: [0, 0, 0],
  normal: [0, 0, 1],
  friction: 0.5,
  motion: still,
  ...change,
});

export const problem = (change = {}) => ({
  name: "incline",
  bodies: [body()],
  obstacles: [obstacle()],
  gravity: constant([0, 0, -9.81]),
  drag: { rate: 0, full_until: 0, ends: 0 },
  loads: [],
  springs: [],
  friction: 0,
  duration: 2,
  ...change,
});

const SLOPE = Math.atan(0.4);

/** A box on an incline, which is gravity turned by tan θ = 0.4. */
export const incline = () =>
  problem({
    gravity: {
      time: [0, 1],
      value: [
        [0, 0, -9.81],
        [9.81 * Math.sin(SLOPE), 0, -9.81 * Math.cos(SLOPE)],
      ],
    },
  });

/** Equal boxes on each other, on level ground. */
export const stack = (count = 2) =>
  problem({
    name: "stack",
    bodies: Array.from({ length: count }, (_, i) =>
      body({
        name: `box ${i + 1}`,
        shape: { box: { size: [0.1, 0.1, 0.1] } },
        position: [0, 0, 0.05 + 0.1 * i],
      }),
    ),
    friction: 0.3,
  });

/** A ball that rolls and spins. */
export const rolling = () =>
  problem({
    name: "ball",
    bodies: [
      body({
        name: "ball",
        shape: { ball: { radius: 0.1 } },
        position: [0, 0, 0.1],
        velocity: [1, 0, 0],
        angular_velocity: [0, 10, 0],
      }),
    ],
  });

/** Boxes between two held bars that press, one of them pushed down and drawn by a spring. */
export const clamp = () => {
  const bar = (side) =>
    body({
      name: side < 0 ? "left bar" : "right bar",
      shape: { box: { size: [0.04, 0.14, 0.14] } },
      position: [side * 0.12, 0, 0],
      held: { point: [side * 0.015, 0, 0], normal: [-side, 0, 0] },
      motion: {
        time: [0, 0.3],
        value: [
          [0, 0, 0],
          [-side * 0.001, 0, 0],
        ],
      },
    });
  return problem({
    name: "clamp",
    bodies: [
      bar(-1),
      body({ name: "held", shape: { box: { size: [0.2, 0.1, 0.1] } }, position: [0, 0, 0] }),
      bar(1),
    ],
    obstacles: [],
    loads: [
      {
        body: 1,
        force: {
          time: [0, 1],
          value: [
            [0, 0, 0],
            [0, 0, -2],
          ],
        },
        couple: still,
      },
      { body: 7, force: constant([1, 0, 0]), couple: still },
    ],
    springs: [
      {
        body: 1,
        anchor: [0, 0, 0.3],
        anchor_velocity: [0, 0, 0.1],
        axis: [0, 0, 1],
        stiffness: 100,
      },
    ],
    friction: 0.5,
    gravity: { time: [], value: [] },
  });
};

/** A mesh, of which only its box is told. */
export const meshed = () =>
  problem({
    name: "mesh",
    bodies: [
      body({
        name: "jack",
        shape: {
          mesh: {
            vertices: 24,
            tetrahedra: 35,
            convex: false,
            low: [-0.075, -0.075, -0.05],
            high: [0.075, 0.075, 0.1],
          },
        },
      }),
    ],
  });

/** What is no problem, or a broken one. */
export const BROKEN = [
  undefined,
  null,
  "text",
  {},
  { bodies: [] },
  { bodies: "many" },
  { bodies: [null, 7, { shape: { box: { size: [1, "x", 2] } } }], obstacles: [null], gravity: 3 },
  {
    bodies: [{ name: {}, shape: { mesh: { low: [0, 0], high: 1 } }, held: true, rotation: [0, 0] }],
    gravity: { time: [0, 1], value: [[0, 0, -1]] },
    loads: [{ body: -1 }, null],
    springs: [{ body: 0.5 }],
    obstacles: [{ normal: [0, 0, 0], friction: "x" }],
    drag: null,
  },
];
