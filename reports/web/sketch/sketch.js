// SPDX-License-Identifier: GPL-3.0-or-later
// A problem as a drawing to scale, seen from the side at its start: what a verification manual shows.
// A pure function to a tree of SVG elements (tree.js).
import { short, slope_text } from "../model/problem_text.js";
import { body_groups, first_of, last_of } from "../model/problem.js";
import { add, dot, scaled, size_of, subtract, turned, unit } from "../model/vector.js";
import { cut_to_box, hull_of } from "./outline.js";
import {
  angle_mark,
  arrow,
  circle,
  dimension,
  face,
  hatched,
  label,
  line,
  plus,
  polygon,
  spring,
  turning_arrow,
  unit_of,
} from "./strokes.js";
import { surface_strokes } from "./surface.js";
import { e } from "./tree.js";
import { bounds_of, corners_of, view_of } from "./view.js";

const WIDTH = 560; // px
const MARGIN = { left: 78, right: 78, top: 46, bottom: 48 };
const MOST_HEIGHT = 230; // of what is drawn, px
const ALONE = 220; // a single body is not drawn wider, px
const ARROW = 40; // of ordinary length, px
const MOST_ARROWS = 8;
const MOST_DIMENSIONS = 4;
const LARGE = 12; // times as far as the others reach: such a body is drawn in part

// The least box [left, low, right, high] around points.
const around = (points) => [
  Math.min(...points.map(([x]) => x)),
  Math.min(...points.map(([, y]) => y)),
  Math.max(...points.map(([x]) => x)),
  Math.max(...points.map(([, y]) => y)),
];
const joined = (a, b) => [
  Math.min(a[0], b[0]),
  Math.min(a[1], b[1]),
  Math.max(a[2], b[2]),
  Math.max(a[3], b[3]),
];
const reach = ([left, low, right, high]) => Math.max(right - left, high - low);

// Where the bodies' middle stands above each half-space that is near enough to be drawn.
function feet_of({ bodies, obstacles }, size, flat) {
  const middle = bodies
    .map(({ position }) => position)
    .reduce(add)
    .map((x) => x / bodies.length);
  return obstacles
    .map(({ point, normal }) => ({ normal, height: dot(subtract(middle, point), normal) }))
    .filter(
      ({ height }) => height > 0 && (size === 0 || (height > size / 2 && height < 1.5 * size)),
    )
    .map(({ normal, height }) => flat(subtract(middle, scaled(normal, height))));
}

// What of the plane is drawn, m: all bodies, of one that is much larger than the others its middle part.
function window_of(problem, flat) {
  const boxes = problem.bodies.map((body) =>
    body.shape.kind === "ball"
      ? [-1, 1].reduce(
          (box, side) => {
            const [x, y] = flat(body.position);
            const r = side * body.shape.radius;
            return joined(box, [x + r, y + r, x + r, y + r]);
          },
          around([flat(body.position)]),
        )
      : around(corners_of(body).map(flat)),
  );
  const all = boxes.reduce(joined);
  const feet = feet_of(problem, reach(all), flat);
  if (feet.length > 0) return joined(all, around(feet));
  const largest = boxes.reduce((a, b) => (reach(b) > reach(a) ? b : a));
  const rest = boxes.filter((box) => box !== largest);
  if (rest.length === 0) return all;
  const others = rest.reduce(joined);
  const part = reach(others);
  if (part === 0 || reach(all) <= LARGE * part) return all;
  const room = 1.2 * part;
  return [
    Math.max(all[0], others[0] - room),
    Math.max(all[1], others[1] - room),
    Math.min(all[2], others[2] + room),
    Math.min(all[3], others[3] + room),
  ];
}

// Metres to px: {at(point), way(vector), scale, height}.
function frame_of(problem, { right, up }) {
  const flat = (point) => [dot(point, right), dot(point, up)];
  let [left, low, end, high] = window_of(problem, flat);
  for (const { anchor, body } of problem.springs) {
    const [x, y] = flat(anchor);
    const own = flat(problem.bodies[body].position);
    if (Math.hypot(x - own[0], y - own[1]) > 3 * Math.hypot(end - left, high - low)) continue;
    [left, low, end, high] = joined([left, low, end, high], [x, y, x, y]);
  }
  const [across, tall] = [end - left, high - low];
  const room = problem.bodies.length > 1 ? WIDTH - MARGIN.left - MARGIN.right : ALONE;
  const most = Math.max(across / room, tall / MOST_HEIGHT);
  const scale = most > 0 ? 1 / most : 1;
  const height = Math.max(96, tall * scale);
  const [x0, y0] = [(left + end) / 2, (low + high) / 2];
  return {
    scale,
    height: height + MARGIN.top + MARGIN.bottom,
    at: (point) => {
      const [x, y] = flat(point);
      return [WIDTH / 2 + (x - x0) * scale, MARGIN.top + height / 2 - (y - y0) * scale];
    },
    way: (vector) => [dot(vector, right), -dot(vector, up)],
  };
}

const FACES = [0, 1, 2].flatMap((axis) =>
  [-1, 1].map((side) => ({
    normal: [0, 1, 2].map((other) => (other === axis ? side : 0)),
    places: [0, 1, 2, 3, 4, 5, 6, 7].filter((i) => ((i >> axis) & 1) === (side > 0 ? 1 : 0)),
  })),
);

// The faces of a box that are seen, as polygons.
function seen_faces(body, corners, near) {
  const faces = FACES.filter(({ normal }) => dot(turned(body.rotation, normal), near) > 0.02);
  return faces.map(({ places }) => hull_of(places.map((i) => corners[i])));
}

// The outline of the held part: corners on its side of the face, and where edges cross it.
function held_outline(body, at) {
  const { shape, held, position, rotation } = body;
  const [low, high] = bounds_of(shape);
  const own = Array.from({ length: 8 }, (_, i) =>
    [0, 1, 2].map((axis) => ((i >> axis) & 1 ? high : low)[axis]),
  );
  const slack = 1e-9 * size_of(subtract(high, low));
  const depth = (x) => slack - dot(subtract(x, held.point), held.normal);
  const points = own.filter((x) => depth(x) >= 0);
  for (let i = 0; i < 8; ++i)
    for (const axis of [0, 1, 2]) {
      const j = i | (1 << axis);
      const [s, t] = [depth(own[i]), depth(own[j])];
      if (s >= 0 !== t >= 0)
        points.push(add(own[i], scaled(subtract(own[j], own[i]), s / (s - t))));
    }
  return hull_of(points.map((x) => at(add(position, turned(rotation, x)))));
}

// A held face without depth, as that of a slab's bottom, is a line with hatching outside.
function held_strokes(body, frame, box) {
  const outline = held_outline(body, frame.at);
  const [left, top, right, bottom] = outline.length > 0 ? around(outline) : [0, 0, 0, 0];
  const normal = unit_of(frame.way(turned(body.rotation, body.held.normal)));
  const spread = outline.map(([x, y]) => x * normal[0] + y * normal[1]);
  if (outline.length > 0 && Math.max(...spread) - Math.min(...spread) < 2) {
    const way = [-normal[1], normal[0]];
    const along = outline.map(([x, y]) => x * way[0] + y * way[1]);
    const [from, to] = [Math.min(...along), Math.max(...along)];
    const [a, b] = [from, to].map((t) => [
      t * way[0] + spread[0] * normal[0],
      t * way[1] + spread[0] * normal[1],
    ]);
    const strip = [a, b, plus(b, normal, -7), plus(a, normal, -7)];
    return [hatched(cut_to_box(strip, box), 7), line(a, b, "ground")];
  }
  return right - left > 1 || bottom - top > 1 ? hatched(cut_to_box(outline, box)) : [];
}

function body_strokes(body, frame, near, box, surface) {
  const { shape } = body;
  if (shape.kind === "point") return circle(frame.at(body.position), 6, "body point");
  if (shape.kind === "ball") {
    const radius = Math.max(2, shape.radius * frame.scale);
    const centre = frame.at(body.position);
    const marked = turned(body.rotation, [0, 0, 1]);
    return [
      circle(centre, radius),
      size_of(body.angular_velocity) > 0 &&
        line(centre, plus(centre, unit_of(frame.way(marked)), radius), "thin"),
    ];
  }
  if (surface) {
    const [left, top, right, bottom] = box;
    const [width, height] = [right - left, bottom - top];
    return e(
      "svg",
      { x: left, y: top, width, height, viewBox: `${left} ${top} ${width} ${height}` },
      surface_strokes(surface, frame.at, near),
    );
  }
  const corners = corners_of(body).map(frame.at);
  if (shape.kind === "mesh") return polygon(cut_to_box(hull_of(corners), box), "body bounding");
  return seen_faces(body, corners, near)
    .map((outline) => cut_to_box(outline, box))
    .filter((outline) => outline.length > 2)
    .map((outline) => polygon(outline));
}

const half = ({ shape }) => scaled(subtract(...[...bounds_of(shape)].reverse()), 0.5);

// Edges of a body that are seen in their true length, each on the side where there is most room.
function dimension_candidates(body, frame) {
  const { shape, position, rotation } = body;
  if (shape.kind === "point") return [];
  const centre =
    shape.kind === "mesh"
      ? add(position, turned(rotation, scaled(add(shape.low, shape.high), 0.5)))
      : position;
  if (shape.kind === "ball") {
    const [x, y] = frame.at(centre);
    const r = shape.radius * frame.scale;
    return [1, -1].map((side) => ({
      key: `ball ${short(shape.radius)}`,
      a: [x - r, y],
      b: [x + r, y],
      out: [0, -side],
      offset: r + 12,
      text: `⌀ ${short(2 * shape.radius)} m`,
    }));
  }
  const axes = [0, 1, 2].map((axis) => {
    const way = turned(
      rotation,
      [0, 1, 2].map((i) => (i === axis ? half(body)[axis] : 0)),
    );
    return { way, size: 2 * size_of(way) };
  });
  return axes.flatMap(({ way, size }, axis) => {
    const seen = frame.way(way);
    if (size === 0 || Math.hypot(...seen) < 0.999 * (size / 2)) return [];
    const out = [-seen[1], seen[0]].map((x) => x / Math.hypot(...seen));
    const others = axes.filter((_, i) => i !== axis);
    const reach_out =
      others.reduce((sum, { way: w }) => sum + Math.abs(dot_flat(frame.way(w), out)), 0) *
      frame.scale;
    const middle = frame.at(centre);
    return [1, -1].map((side) => {
      const outwards = out.map((x) => side * x);
      const edge = plus(middle, outwards, reach_out);
      return {
        key: `${Math.abs(seen[0]) > Math.abs(seen[1]) ? "across" : "tall"} ${short(size)}`,
        a: plus(edge, seen, -frame.scale),
        b: plus(edge, seen, frame.scale),
        out: outwards,
        offset: 12,
        text: `${short(size)} m`,
      };
    });
  });

  function dot_flat(a, b) {
    return a[0] * b[0] + a[1] * b[1];
  }
}

const overlaps = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

// The box that a dimension's line and number take.
function room_of({ a, b, out, offset, text }) {
  const from = plus(a, out, offset);
  const to = plus(b, out, offset);
  const number = plus([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2], out, 9);
  const wide = 7.4 * text.length;
  const side = Math.abs(out[0]) > 0.5 ? Math.sign(out[0]) : 0;
  const left = number[0] - (side > 0 ? 0 : side < 0 ? wide : wide / 2);
  return joined(around([from, to]), [left, number[1] - 7, left + wide, number[1] + 7]);
}

function room_of_body(body, frame) {
  if (body.shape.kind !== "ball") return around(corners_of(body).map(frame.at));
  const [x, y] = frame.at(body.position);
  const r = body.shape.radius * frame.scale;
  return [x - r, y - r, x + r, y + r];
}

// `taken`: boxes where other marks stand.
function dimensions(problem, frame, { obstacles, boxes, surfaces, taken }) {
  const inside = obstacles.map(
    ({ point, normal }) =>
      ([left, top, right, bottom]) =>
        [left, right].some((x) =>
          [top, bottom].some((y) => (x - point[0]) * normal[0] + (y - point[1]) * normal[1] < -4),
        ),
  );
  const cost = (candidate) => {
    const room = room_of(candidate);
    const outside =
      room[0] < 2 || room[1] < 2 || room[2] > WIDTH - 2 || room[3] > frame.height - 2 ? 8 : 0;
    return (
      outside +
      6 * taken.filter((other) => overlaps(room, other)).length +
      boxes.filter((box) => overlaps(room, box)).length +
      2 * inside.filter((is_inside) => is_inside(room)).length +
      (candidate.out[1] > 0.5 ? 0.5 : 0)
    );
  };
  const drawn = [];
  const told = new Set();
  const whole = (place) => !surfaces.has(place) || is_box(surfaces.get(place));
  for (const { places } of body_groups(problem)) {
    const candidates = new Map();
    for (const place of places.filter(whole).slice(0, 12))
      for (const one of dimension_candidates(problem.bodies[place], frame))
        candidates.set(one.key, [...(candidates.get(one.key) ?? []), one]);
    for (const [key, list] of candidates) {
      if (told.has(key) || drawn.length >= MOST_DIMENSIONS) continue;
      const best = list
        .map((one) => ({ one, cost: cost(one) }))
        .reduce((a, b) => (b.cost < a.cost ? b : a));
      if (best.cost >= 6) continue;
      told.add(key);
      taken.push(room_of(best.one));
      const { a, b, out, offset, text } = best.one;
      drawn.push(dimension(a, b, out, offset, text));
    }
  }
  return drawn.length > 0 ? drawn : overall_dimensions(boxes, frame);
}

// Of shapes that are no boxes: how far all reach.
function overall_dimensions(boxes, { scale }) {
  const [left, top, right, bottom] = boxes.reduce(joined);
  if (right - left < 1 || bottom - top < 1) return [];
  const text = (size) => `${short(Number((size / scale).toPrecision(3)))} m`;
  return [
    dimension([left, top], [right, top], [0, -1], 12, text(right - left)),
    dimension([right, top], [right, bottom], [1, 0], 12, text(bottom - top)),
  ];
}

// Whether a surface is that of a box: eight vertices are farther from the middle than all between them.
function is_box({ vertices }) {
  const middle = vertices.reduce(add).map((x) => x / vertices.length);
  const sizes = vertices.map((vertex) => size_of(subtract(vertex, middle)));
  const most = Math.max(...sizes);
  return sizes.filter((size) => size > 0.98 * most).length === 8;
}

const amount = (vector, unit_name) => `${short(size_of(vector))} ${unit_name}`;

// The largest value over time: a push may end before the run does.
const largest_of = ({ value }) =>
  value.reduce((a, b) => (size_of(b) > size_of(a) ? b : a), [0, 0, 0]);

// Arrows of what acts and moves: {strokes, used}, the words for the key.
function actions(problem, obstacles, frame, { near, up }) {
  const used = new Map();
  const strokes = [];
  const rooms = [];
  let count = 0;
  const write = (at, text, options = {}) => {
    if (text === "") return;
    const wide = 7 * text.length;
    const left = at[0] - { start: 0, middle: wide / 2, end: wide }[options.anchor ?? "middle"];
    rooms.push([left, at[1] - 12, left + wide, at[1] + 3]);
    strokes.push(label(at, text, { name: "label small", ...options }));
  };
  const add_arrow = (from, vector, name, word, text) => {
    const way = frame.way(vector);
    if (size_of(vector) === 0 || Math.hypot(...way) < 0.2 * size_of(vector)) return;
    if (++count > MOST_ARROWS) return;
    used.set(name, word);
    const reach_px = unit_of(way).map((x) => x * ARROW);
    const tip = plus(from, reach_px);
    rooms.push(around([from, tip]));
    strokes.push(arrow(from, reach_px, name));
    write([tip[0] + (way[0] >= 0 ? 4 : -4), tip[1] - 6], text, {
      anchor: way[0] >= 0 ? "start" : "end",
    });
  };
  // About an axis in the picture's plane it is drawn flat, as seen from the side.
  const add_turn = (at, vector, name, word, unit_name) => {
    if (size_of(vector) === 0 || ++count > MOST_ARROWS) return;
    const spin = dot(vector, near);
    const flat = Math.abs(spin) < 0.3 * size_of(vector);
    used.set(name, word);
    strokes.push(turning_arrow(at, 18, flat ? dot(vector, up) < 0 : spin < 0, name, flat ? 6 : 18));
    write(plus(at, [0, flat ? -14 : -25]), once(amount(vector, unit_name)));
  };
  const told = new Set(); // a number that many share is written once
  const once = (text) => (told.has(text) ? "" : (told.add(text), text));

  for (const { body, anchor, anchor_velocity, axis, stiffness } of problem.springs) {
    const own = frame.at(problem.bodies[body].position);
    const end = frame.at(anchor);
    const way = [end[0] - own[0], end[1] - own[1]];
    const length = Math.hypot(...way);
    const slack = length < 1; // it is drawn to where it will pull
    const along = slack ? frame.way(size_of(anchor_velocity) > 0 ? anchor_velocity : axis) : way;
    const stop = plus(own, unit_of(along), slack ? 190 : Math.max(50, Math.min(length, 260)));
    strokes.push(spring(own, stop));
    used.set("spring", "spring");
    rooms.push(around([own, stop]));
    write(plus(stop, [0, -9]), once(`k = ${short(stiffness)} N/m`));
    add_arrow(
      plus(stop, [0, 12]),
      anchor_velocity,
      "motion",
      "motion",
      once(amount(anchor_velocity, "m/s")),
    );
  }
  for (const body of problem.bodies) {
    const from = frame.at(body.position);
    add_arrow(from, body.velocity, "motion", "motion", once(amount(body.velocity, "m/s")));
    add_turn(from, body.angular_velocity, "motion", "motion", "rad/s");
    const way = largest_of(body.motion);
    add_arrow(from, way, "motion", "motion", once(`moved ${amount(way, "m")}`));
  }
  for (const { point, normal, motion } of obstacles) {
    const way = largest_of(motion);
    const from = plus(plus(point, normal, -ARROW - 14), [-normal[1], normal[0]], 30);
    add_arrow(from, way, "motion", "motion", once(`moved ${amount(way, "m")}`));
  }
  for (const { body, force, couple } of problem.loads) {
    const at = frame.at(problem.bodies[body].position);
    const push = largest_of(force);
    add_arrow(at, push, "force", "load", once(amount(push, "N")));
    add_turn(at, largest_of(couple), "force", "load", "N m");
  }
  return { strokes, used, rooms };
}

// Below the upper edge where most room is: at the left, or at the right.
function gravity_place(obstacles, boxes) {
  const spots = [
    [8, 6, 150, 56],
    [WIDTH - 150, 6, WIDTH - 8, 56],
  ];
  const cost = ([left, top, right, bottom]) => {
    const corners = [
      [left, top],
      [right, top],
      [right, bottom],
      [left, bottom],
    ];
    const crossed = obstacles.filter(({ point, normal }) => {
      const sides = corners.map(
        ([x, y]) => (x - point[0]) * normal[0] + (y - point[1]) * normal[1] > 0,
      );
      return sides.some((side) => side !== sides[0]);
    });
    return (
      crossed.length +
      boxes.filter((box) =>
        overlaps(
          box,
          spots.find(([x]) => x === left),
        ),
      ).length
    );
  };
  return cost(spots[1]) < cost(spots[0]) ? spots[1] : spots[0];
}

function gravity_strokes({ gravity }, [left]) {
  const g = last_of(gravity);
  if (size_of(g) === 0) return [];
  return [
    arrow([left + 14, 14], [0, 34], "weight"),
    label([left + 23, 28], `g = ${short(size_of(g))} m/s²`, {
      anchor: "start",
      name: "label small",
    }),
  ];
}

// The angle of the slope, at the foot of the face that has it; of a slab, at its lowest corner.
function slope_strokes(problem, slope, frame, box) {
  if (!slope) return { strokes: [], room: [0, 0, 0, 0] };
  const text = slope_text(slope);
  const obstacle = problem.obstacles.find(({ normal }) => normal === slope.normal);
  const [, , right, bottom] = box;
  const way = [Math.cos(slope.angle), Math.sin(slope.angle)];
  const feet = obstacle
    ? [frame.at(obstacle.point)]
    : problem.bodies
        .filter(({ shape }) => shape.kind !== "point")
        .flatMap((body) => corners_of(body).map(frame.at));
  const start = obstacle ? feet[0] : feet.reduce((a, b) => (b[1] > a[1] ? b : a));
  const steps = obstacle
    ? Math.min((right - 6 - start[0]) / way[0], (bottom - 6 - start[1]) / Math.max(way[1], 1e-9))
    : 0;
  const corner = plus(start, way, steps);
  const radius = Math.min(70, Math.max(44, 900 / (60 * slope.angle + 8)));
  const [x, y] = corner;
  return {
    strokes: angle_mark(corner, slope.angle, radius, text),
    room: [x - 1.4 * radius - 7.4 * text.length, y - 8, x, y + 14],
  };
}

const KEY = { weight: "gravity", force: "load", motion: "motion", spring: "spring" };

/**
 * {drawing, caption}: the SVG as a tree, and in one sentence how it is seen. `surfaces`, where a recording
 * has them, are the bodies' at the start: Map from a body's place to {vertices: [[x, y, z]], triangles}.
 */
export function problem_sketch(problem, { surfaces = new Map(), title = "" } = {}) {
  const view = view_of(problem);
  const frame = frame_of(problem, view);
  const box = [6, 6, WIDTH - 6, frame.height - 6];
  const middle = problem.bodies
    .map(({ position }) => position)
    .reduce(add)
    .map((x) => x / problem.bodies.length);
  const depth_of = ({ position }) => dot(position, view.near);

  // Where a half-space cuts the plane of the picture; one that faces the reader has no line in it.
  const obstacles = problem.obstacles
    .map((obstacle) => {
      const normal = frame.way(obstacle.normal);
      const length = Math.hypot(...normal);
      if (length < 0.05) return null;
      const inner = dot(subtract(middle, obstacle.point), obstacle.normal);
      const on_face = subtract(middle, scaled(obstacle.normal, inner));
      // From the middle's foot back along the face, within the picture's plane.
      const point = frame.at(on_face);
      const off = dot(subtract(on_face, middle), view.near);
      const shift = (off * dot(obstacle.normal, view.near)) / length;
      const flat = normal.map((x) => x / length);
      return { ...obstacle, point: plus(point, flat, shift * frame.scale), normal: flat };
    })
    .filter(Boolean);
  const ordered = problem.bodies
    .map((body, place) => ({ body, place }))
    .sort((a, b) => depth_of(a.body) - depth_of(b.body));
  const acting = actions(problem, obstacles, frame, view);
  const boxes = problem.bodies.map((body) => room_of_body(body, frame));
  const place = gravity_place(obstacles, boxes);
  const weight = gravity_strokes(problem, place);
  const slope = slope_strokes(problem, view.slope, frame, box);
  const used = [...(weight.length > 0 ? ["weight"] : []), ...acting.used.keys()];
  const drawing = e(
    "svg",
    {
      class: "sketch",
      viewBox: `0 0 ${WIDTH} ${Math.round(frame.height)}`,
      role: "img",
      "aria-label": `Sketch of the problem${title ? ` of ${title}` : ""}, from the side`,
    },
    obstacles.map(({ point, normal }) => face(point, normal, box)),
    ordered.map(({ body, place }) => [
      body_strokes(body, frame, view.near, box, surfaces.get(place)),
      body.held && held_strokes(body, frame, box),
    ]),
    slope.strokes,
    dimensions(problem, frame, {
      obstacles,
      boxes,
      surfaces,
      taken: [place, slope.room, ...acting.rooms],
    }),
    acting.strokes,
    weight,
    obstacles.map((obstacle) => friction_label(obstacle, obstacles, box)),
  );
  return {
    drawing,
    caption: caption_of(problem, view, surfaces),
    key: used.map((name) => [name, KEY[name]]),
  };
}

// μ at the inner end of a face.
function friction_label({ point, normal, friction }, obstacles, box) {
  const [left, top, right, bottom] = box;
  const text = `μ = ${short(friction)}`;
  const level = Math.abs(normal[1]) > 0.5;
  const t = level ? (left + 24 - point[0]) / -normal[1] : (bottom - 14 - point[1]) / normal[0];
  const at = plus(point, [-normal[1], normal[0]], t);
  // A text below a line that falls to the right must keep clear of it on its whole length.
  const out = plus(at, normal, level ? -18 - 44 * Math.max(0, normal[0]) : -18);
  if (out[0] < left || out[0] > right || out[1] < top || out[1] > bottom + 4) return null;
  return label([out[0], out[1] + 4], text, {
    anchor: level || normal[0] < 0 ? "start" : "end",
    name: "label small",
  });
}

function caption_of(problem, { slope }, surfaces) {
  const meshes = problem.bodies.filter(
    ({ shape }, place) => shape.kind === "mesh" && !surfaces.has(place),
  );
  const g = [first_of(problem.gravity), last_of(problem.gravity)];
  const is_turned =
    slope !== null && unit(g[1]) !== null && Math.abs(dot(unit(g[1]), [0, 0, 1])) < 1 - 1e-9;
  return [
    "At the start, from the side, to scale",
    is_turned ? "; turned so that gravity at its end points down" : "",
    meshes.length > 0 ? "; dashed: the box around a mesh" : "",
    problem.bodies.some(({ held }) => held) ? "; hatched: held" : "",
    ".",
  ].join("");
}
