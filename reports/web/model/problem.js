// SPDX-License-Identifier: GPL-3.0-or-later
// The problem of a record, as the engine protocol writes it (validation/engine/protocol/README.md): checked,
// with what may miss filled in. Records are not trusted: what is no number becomes what stands for none.
import { across, dot, scaled, size_of, turned, unit } from "./vector.js";

const ORIGIN = [0, 0, 0];
const MOST_BODIES = 2000;

const is_numbers = (value, count) =>
  Array.isArray(value) && value.length === count && value.every(Number.isFinite);
const triple = (value, otherwise = ORIGIN) => (is_numbers(value, 3) ? value : otherwise);
const number = (value, otherwise = 0) => (Number.isFinite(value) ? value : otherwise);
const text = (value) => (typeof value === "string" ? value : "");
const list = (value) => (Array.isArray(value) ? value : []);
const direction = (value, otherwise) => unit(triple(value, otherwise)) ?? otherwise;

function over_time(value) {
  const [time, values] = [list(value?.time), list(value?.value)];
  const whole =
    time.length === values.length &&
    time.every(Number.isFinite) &&
    values.every((one) => is_numbers(one, 3));
  const swings = value?.oscillation;
  return {
    ...(whole ? { time, value: values } : { time: [], value: [] }),
    velocity: triple(value?.velocity),
    amplitude: triple(swings?.amplitude),
    frequency: number(swings?.frequency),
  };
}

/** A quantity at its start and at its end: zero where it has no value. */
export const first_of = ({ value }) => value[0] ?? ORIGIN;
export const last_of = ({ value }) => value.at(-1) ?? ORIGIN;

function shape_of({ box, ball, mesh } = {}) {
  if (is_numbers(box?.size, 3)) return { kind: "box", size: box.size };
  if (Number.isFinite(ball?.radius)) return { kind: "ball", radius: ball.radius };
  if (mesh && is_numbers(mesh.low, 3) && is_numbers(mesh.high, 3))
    return {
      kind: "mesh",
      low: mesh.low,
      high: mesh.high,
      vertices: number(mesh.vertices),
      tetrahedra: number(mesh.tetrahedra),
    };
  return { kind: "point" };
}

const body_of = (body) => ({
  name: text(body?.name),
  shape: shape_of(body?.shape ?? {}),
  mass: number(body?.mass, 1),
  youngs_modulus: number(body?.elasticity?.youngs_modulus, NaN),
  poisson_ratio: number(body?.elasticity?.poisson_ratio, NaN),
  damping_time: number(body?.elasticity?.damping_time),
  position: triple(body?.position),
  rotation: is_numbers(body?.rotation, 4) ? body.rotation : [1, 0, 0, 0],
  velocity: triple(body?.velocity),
  angular_velocity: triple(body?.angular_velocity),
  held: body?.held
    ? { point: triple(body.held.point), normal: direction(body.held.normal, [0, 0, 1]) }
    : null,
  motion: over_time(body?.motion),
  self_collision: body?.self_collision === true,
});

const obstacle_of = (obstacle) => ({
  name: text(obstacle?.name),
  point: triple(obstacle?.point),
  normal: direction(obstacle?.normal, [0, 0, 1]),
  friction: number(obstacle?.friction),
  motion: over_time(obstacle?.motion),
});

/** The problem of a record's first simulation; null where it tells none. */
export function problem_of({ problem }) {
  const bodies = list(problem?.bodies).slice(0, MOST_BODIES).map(body_of);
  if (bodies.length === 0) return null;
  const acts = ({ body }) => Number.isInteger(body) && body >= 0 && body < bodies.length;
  return {
    name: text(problem.name),
    bodies,
    obstacles: list(problem.obstacles).map(obstacle_of),
    gravity: over_time(problem.gravity),
    drag: {
      rate: number(problem.drag?.rate),
      full_until: number(problem.drag?.full_until),
      ends: number(problem.drag?.ends),
    },
    loads: list(problem.loads)
      .map((load) => ({
        body: load?.body,
        force: over_time(load?.force),
        couple: over_time(load?.couple),
      }))
      .filter(acts),
    springs: list(problem.springs)
      .map((spring) => ({
        body: spring?.body,
        anchor: triple(spring?.anchor),
        anchor_velocity: triple(spring?.anchor_velocity),
        axis: direction(spring?.axis, [1, 0, 0]),
        stiffness: number(spring?.stiffness),
      }))
      .filter(acts),
    friction: number(problem.friction),
    duration: number(problem.duration),
  };
}

/** Unit vector against gravity at the end; where nothing weighs, out of the first obstacle. */
export function up_of({ gravity, obstacles }) {
  return unit(scaled(last_of(gravity), -1)) ?? obstacles[0]?.normal ?? [0, 0, 1];
}

const DEGREE = Math.PI / 180;
const LEAST = 0.02 * DEGREE;

// What bodies stand on, as normals: obstacles, held parts, and what was level before gravity turned.
function stands(problem) {
  const level = unit(scaled(first_of(problem.gravity), -1));
  return [
    ...problem.obstacles.map(({ name, normal, friction }) => ({ name, normal, friction })),
    ...problem.bodies
      .filter(({ held }) => held)
      .map(({ name, rotation, held }) => ({
        name,
        normal: turned(rotation, held.normal),
        friction: problem.friction,
      })),
    ...(level ? [{ name: "", normal: level, friction: problem.friction }] : []),
    ...(problem.bodies.length > 1
      ? [{ name: "", normal: [0, 0, 1], friction: problem.friction }]
      : []),
  ];
}

/**
 * The slope on which it goes: {angle in rad, normal, friction, name}, that of the first face which is tilted
 * against gravity but not upright; null where all is level or nothing weighs.
 */
export function slope_of(problem) {
  const g = last_of(problem.gravity);
  if (size_of(g) === 0) return null;
  const up = up_of(problem);
  for (const { name, normal, friction } of stands(problem)) {
    const angle = Math.atan2(size_of(across(normal, up)), dot(normal, up));
    if (angle < LEAST) return null;
    if (angle < 85 * DEGREE) return { angle, normal, friction, name };
  }
  return null;
}

const shape_key = ({ shape, mass, youngs_modulus, poisson_ratio, damping_time, held, motion }) =>
  JSON.stringify([shape, mass, youngs_modulus, poisson_ratio, damping_time, held, motion]);

/** Equal bodies together, in the order of the first of each: [{bodies, places}]. */
export function body_groups({ bodies }) {
  const groups = new Map();
  bodies.forEach((body, place) => {
    const key = shape_key(body);
    if (!groups.has(key)) groups.set(key, { bodies: [], places: [] });
    groups.get(key).bodies.push(body);
    groups.get(key).places.push(place);
  });
  return [...groups.values()];
}
