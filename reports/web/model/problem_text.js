// SPDX-License-Identifier: GPL-3.0-or-later
// A problem in words and numbers, for the page and for the manual.
import { format_count, format_value, to_number } from "./number.js";
import { body_groups, first_of, last_of, slope_of } from "./problem.js";
import { dot, size_of, subtract, turned, unit } from "./vector.js";

const PREFIXES = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
];

/** Four significant digits at most; what round-off left of a zero is one. */
export const short = (value, size = 1) =>
  Math.abs(value) < 1e-12 * size
    ? "0"
    : format_value(Number(value.toPrecision(4))).replace("-", "−");

/** "500 kPa" */
export function with_prefix(value, unit_name) {
  const [factor, sign] = PREFIXES.find(([limit]) => Math.abs(value) >= limit) ?? [1, ""];
  return `${short(value / factor)} ${sign}${unit_name}`;
}

/** "1 ms" */
const milliseconds = (value) => (value === 0 ? "none" : `${short(1000 * value)} ms`);

export function vector_text(vector) {
  const size = size_of(vector);
  return `(${vector.map((x) => short(x, size)).join(", ")})`;
}

/** "+x", "−z", "(0.342, 0, −0.9397)". */
export function direction_text(vector) {
  const way = unit(vector);
  if (!way) return "";
  const axis = way.findIndex((x) => Math.abs(x) > 1 - 1e-9);
  return axis < 0 ? vector_text(way) : `${way[axis] > 0 ? "+" : "−"}${"xyz"[axis]}`;
}

const along = (vector, unit_name) =>
  `${short(size_of(vector))} ${unit_name} along ${direction_text(vector)}`;

const is_zero = (vector) => size_of(vector) === 0;
const quoted = (name) => (name ? `‘${name}’` : "without a name");

export function shape_text({ kind, size, radius, low, high, tetrahedra }) {
  if (kind === "box") return `box ${size.map((x) => short(x)).join(" × ")} m`;
  if (kind === "ball") return `ball, radius ${short(radius)} m`;
  if (kind === "point") return "point";
  const extent = subtract(high, low).map((x) => short(x));
  return `mesh of ${format_count(tetrahedra)} tetrahedra in ${extent.join(" × ")} m`;
}

function volume_of({ kind, size, radius }) {
  if (kind === "box") return size[0] * size[1] * size[2];
  if (kind === "ball") return (4 / 3) * Math.PI * radius ** 3;
  return NaN;
}

const PLURALS = { box: "boxes", ball: "balls", mesh: "meshes", point: "points" };

function group_name({ bodies }) {
  const names = bodies.map(({ name }) => name);
  if (bodies.length === 1) return names[0] || "body";
  const between = bodies.length > 2 ? " … " : ", ";
  return `${bodies.length} ${PLURALS[bodies[0].shape.kind]}: ${names[0]}${between}${names.at(-1)}`;
}

const MOST_ROWS = 6;

// Where there are many groups, those of one material together.
function rows_of(problem) {
  const groups = body_groups(problem);
  if (groups.length <= MOST_ROWS) return groups;
  const merged = new Map();
  for (const { bodies } of groups) {
    const [{ shape, youngs_modulus, poisson_ratio, damping_time }] = bodies;
    const key = [shape.kind, youngs_modulus, poisson_ratio, damping_time].join();
    merged.set(key, { bodies: [...(merged.get(key)?.bodies ?? []), ...bodies] });
  }
  return [...merged.values()];
}

// "1 to 3 kg" of several, the one number of equals.
function range_text(values) {
  const [low, high] = [Math.min(...values), Math.max(...values)].map((x) => short(x));
  return low === high ? low : `${low} to ${high}`;
}

function shapes_text(bodies) {
  const texts = new Set(bodies.map(({ shape }) => shape_text(shape)));
  if (texts.size === 1) return [...texts][0];
  const sizes = bodies.map(({ shape }) =>
    shape.kind === "ball"
      ? 2 * shape.radius
      : Math.max(...(shape.kind === "box" ? shape.size : subtract(shape.high, shape.low))),
  );
  return `${texts.size} different ${PLURALS[bodies[0].shape.kind]}, longest edge ${range_text(sizes)} m`;
}

/** A row a group of equal bodies: {name, shape, mass, density, youngs_modulus, poisson_ratio, damping}. */
export const body_rows = (problem) =>
  rows_of(problem).map((group) => {
    const [body] = group.bodies;
    const densities = group.bodies.map(({ mass, shape }) => mass / volume_of(shape));
    const deforms = body.shape.kind !== "point";
    return {
      name: group_name(group),
      shape: shapes_text(group.bodies),
      mass: range_text(group.bodies.map(({ mass }) => mass)),
      density: densities.every(Number.isFinite) ? range_text(densities) : "–",
      youngs_modulus:
        deforms && Number.isFinite(body.youngs_modulus)
          ? with_prefix(body.youngs_modulus, "Pa")
          : "–",
      poisson_ratio:
        deforms && Number.isFinite(body.poisson_ratio) ? short(body.poisson_ratio) : "–",
      damping: deforms ? milliseconds(body.damping_time) : "–",
    };
  });

// "0.5 m along +x from 0 to 1 s, swings by 1 mm along +x at 5 Hz": what changes with time.
const course = (values, unit_name) =>
  [
    stages(values, unit_name),
    !is_zero(values.velocity) && `steadily by ${along(values.velocity, "m/s")}`,
    swings_text(values, unit_name),
  ]
    .filter(Boolean)
    .join(", ");

const swings_text = ({ amplitude, frequency }, unit_name) =>
  is_zero(amplitude) ? "" : `to and fro by ${along(amplitude, unit_name)} at ${short(frequency)} Hz`;

function stages(values, unit_name) {
  const [from, to] = [first_of(values), last_of(values)];
  if (values.value.length < 2) return is_zero(to) ? "" : along(to, unit_name);
  const times = `from ${short(values.time[0])} to ${short(values.time.at(-1))} s`;
  if (values.value.every(is_zero)) return "";
  const between = values.value.length > 2 ? `in ${values.value.length} stages, ` : "";
  if (is_zero(from) && is_zero(to)) {
    const most = values.value.reduce((a, b) => (size_of(b) > size_of(a) ? b : a));
    return `for a while, at most ${along(most, unit_name)}, ${times}`;
  }
  if (is_zero(from) && !is_zero(to)) return `${between}up to ${along(to, unit_name)}, ${times}`;
  return `${between}${vector_text(from)} to ${vector_text(to)} ${unit_name}, ${times}`;
}

const gravity_text = ({ gravity }) =>
  [gravity_stages(gravity), swings_text(gravity, "m/s²")].filter(Boolean).join(", ");

function gravity_stages(gravity) {
  const [from, to] = [first_of(gravity), last_of(gravity)];
  const moving = gravity.value.some((value) => !is_zero(subtract(value, to)));
  if (!moving) return is_zero(to) ? "none" : along(to, "m/s²");
  const size = Math.max(...gravity.value.map(size_of));
  const turns =
    !is_zero(from) && Math.abs(size_of(from) - size_of(to)) < 1e-9 * size
      ? `${short(size)} m/s², turned from ${direction_text(from)} to ${direction_text(to)}`
      : `from ${is_zero(from) ? "0" : along(from, "m/s²")} to ${is_zero(to) ? "0" : along(to, "m/s²")}`;
  return `${turns}, between ${short(gravity.time[0])} and ${short(gravity.time.at(-1))} s`;
}

/** "θ = 26.57°, tan θ = 0.5"; more digits where a threshold needs them. */
export const slope_text = ({ angle }) =>
  `θ = ${short((angle * 180) / Math.PI)}°, tan θ = ${format_value(Math.tan(angle))}`;

const MOST_LINES = 8;

function lines(texts) {
  const unique = [...new Set(texts.filter(Boolean))];
  return unique.length <= MOST_LINES
    ? unique
    : [...unique.slice(0, MOST_LINES - 1), `and ${unique.length - MOST_LINES + 1} more`];
}

// Bodies with the same text, named together.
function told_together(problem, text_of) {
  const by_text = new Map();
  for (const body of problem.bodies) {
    const told = text_of(body);
    if (told) by_text.set(told, [...(by_text.get(told) ?? []), body.name]);
  }
  return [...by_text].map(([told, names]) =>
    names.length === problem.bodies.length && names.length > 1
      ? `all bodies: ${told}`
      : `${names.length > 3 ? `${names.slice(0, 2).map(quoted).join(", ")} and ${names.length - 2} more` : names.map(quoted).join(", ")}: ${told}`,
  );
}

function initial_lines(problem) {
  const told = told_together(problem, ({ velocity, angular_velocity }) =>
    [
      !is_zero(velocity) && along(velocity, "m/s"),
      !is_zero(angular_velocity) && `spins at ${along(angular_velocity, "rad/s")}`,
    ]
      .filter(Boolean)
      .join(", "),
  );
  return told.length > 0 ? told : ["all at rest"];
}

function held_lines(problem) {
  return told_together(problem, ({ rotation, held, motion }) => {
    if (!held) return "";
    const way = course(motion, "m");
    return `the part beyond its face towards ${direction_text(turned(rotation, held.normal))}${way ? `, moved ${way}` : ""}`;
  });
}

function obstacle_lines({ obstacles }) {
  return obstacles.map(({ name, point, normal, friction, motion }) => {
    const way = course(motion, "m");
    const offset = dot(point, normal);
    return (
      `half-space ${quoted(name)}: μ = ${short(friction)}, its face towards ${direction_text(normal)}, ` +
      `${offset === 0 ? "through the origin" : `${short(offset)} m from the origin`}${way ? `, moved ${way}` : ""}`
    );
  });
}

function load_lines({ bodies, loads }) {
  return loads.flatMap(({ body, force, couple }) => {
    const on = `on ${quoted(bodies[body].name)}`;
    const [pushes, turns] = [course(force, "N"), course(couple, "N m")];
    return [pushes && `force ${pushes}, ${on}`, turns && `couple ${turns}, ${on}`];
  });
}

const spring_lines = ({ bodies, springs }) =>
  springs.map(
    ({ body, anchor, anchor_velocity, axis, stiffness }) =>
      `${short(stiffness)} N/m along ${direction_text(axis)} from ${quoted(bodies[body].name)} to an anchor at ${vector_text(anchor)} m` +
      (is_zero(anchor_velocity) ? "" : ` that moves ${along(anchor_velocity, "m/s")}`),
  );

const drag_text = ({ rate, full_until, ends }) =>
  `force −m c v, c = ${short(rate)} 1/s until ${short(full_until)} s, none from ${short(ends)} s on`;

// 1 s is what a problem says that a case follows for as long as it takes: then its series tell.
function duration_lines({ duration }, series) {
  if (duration !== 1) return [`${short(duration)} s`];
  const ends = series
    .filter(({ x_name, x_unit, x }) => x_name === "time" && x_unit === "s" && x.length > 0)
    .map(({ x }) => to_number(x.at(-1)))
    .filter(Number.isFinite);
  return ends.length > 0 ? [`followed for ${short(Math.max(...ends))} s`] : [];
}

/**
 * What there is beside the bodies, as [{name, lines}]; what a problem has not is left out. `series` are the
 * record's, which tell how long it was followed.
 */
export function problem_facts(problem, { simulations = 0, series = [] } = {}) {
  const slope = slope_of(problem);
  const touches =
    problem.bodies.length > 1 || problem.bodies.some(({ self_collision }) => self_collision);
  return [
    ["Obstacles", lines(obstacle_lines(problem))],
    ["Between bodies", touches ? [`μ = ${short(problem.friction)}`] : []],
    ["Gravity", [gravity_text(problem)]],
    ["Slope", slope ? [slope_text(slope)] : []],
    ["Held", lines(held_lines(problem))],
    ["Loads", lines(load_lines(problem))],
    ["Springs", lines(spring_lines(problem))],
    ["At the start", lines(initial_lines(problem))],
    ["Drag", problem.drag.rate > 0 ? [drag_text(problem.drag)] : []],
    ["Duration", duration_lines(problem, series)],
    [
      "Simulations",
      simulations > 1 ? [`this is the first of ${format_count(simulations)} simulations`] : [],
    ],
  ]
    .filter(([, told]) => told.length > 0)
    .map(([name, told]) => ({ name, lines: told }));
}
