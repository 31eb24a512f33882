// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded instant as a plain drawing: on paper, and where there is no WebGL. Parallel projection,
// faces painted from back to front.
import { body_colour, PALETTES } from "../../plots/palette.js";
import { svg } from "../dom.js";

const MOST_TRIANGLES = 6000;

// From front left above: x to the right, z up.
const [C, S] = [Math.cos(0.35), Math.sin(0.35)];
const TILT = 0.42;

// The turn that makes `up` point along z, as a function of points.
function uprighted(up) {
  const size = Math.hypot(...up) || 1;
  const [a, b, c] = up.map((x) => x / size);
  if (c < -0.999999) return ([x, y, z]) => [x, -y, -z];
  const k = 1 / (1 + c); // Rodrigues' formula about up × z
  return ([x, y, z]) => [
    (1 - k * a * a) * x - k * a * b * y - a * z,
    -k * a * b * x + (1 - k * b * b) * y - b * z,
    a * x + b * y + c * z,
  ];
}

function project([x, y, z]) {
  const across = C * x + S * y;
  const depth = -S * x + C * y;
  return {
    x: across,
    y: -(z * Math.cos(TILT) + depth * Math.sin(TILT)),
    depth: depth * Math.cos(TILT) - z * Math.sin(TILT),
  };
}

// The piece of a half-space's face below the scene, as four points.
function piece_of({ point, normal }, { centre, radius }) {
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const unit = (a) => a.map((x) => x / Math.hypot(...a));
  const n = unit(normal);
  const height = dot(
    n,
    centre.map((x, i) => x - point[i]),
  );
  const foot = centre.map((x, i) => x - height * n[i]);
  const across = unit(Math.abs(n[0]) < 0.9 ? [0, n[2], -n[1]] : [-n[2], 0, n[0]]); // at right angles to n
  const along = [
    n[1] * across[2] - n[2] * across[1],
    n[2] * across[0] - n[0] * across[2],
    n[0] * across[1] - n[1] * across[0],
  ];
  return [
    [1, 1],
    [1, -1],
    [-1, -1],
    [-1, 1],
  ].map(([a, b]) => foot.map((x, i) => x + radius * (a * across[i] + b * along[i])));
}

const point_of = (positions, i) => [positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]];

/** An SVG element of the surfaces and contacts; `view` as playback.js gives it. */
export function still(recording, { positions, contacts, up }, view) {
  const turn = uprighted(up);
  const planes = recording.planes.map((plane) => piece_of(plane, view));
  const box = Array.from({ length: 8 }, (_, i) =>
    view.centre.map((x, axis) => x + ((i >> axis) & 1 ? 0.8 : -0.8) * view.radius),
  );
  const corners = [...box, ...planes.flat()].map((point) => project(turn(point)));
  const [left, right] = [
    Math.min(...corners.map(({ x }) => x)),
    Math.max(...corners.map(({ x }) => x)),
  ];
  const [top, bottom] = [
    Math.min(...corners.map(({ y }) => y)),
    Math.max(...corners.map(({ y }) => y)),
  ];
  const scale = 300 / Math.max(right - left, 1.5 * (bottom - top), 1e-12);
  const at = (point) => {
    const { x, y, depth } = project(turn(point));
    return [(x - left) * scale + 10, (y - top) * scale + 10, depth];
  };

  const faces = [];
  let first = 0;
  recording.bodies.forEach((body, place) => {
    for (let i = 0; i < body.triangles.length && faces.length < MOST_TRIANGLES; i += 3) {
      const points = [0, 1, 2].map((corner) =>
        at(point_of(positions, first + body.triangles[i + corner])),
      );
      faces.push({
        points,
        depth: (points[0][2] + points[1][2] + points[2][2]) / 3,
        colour: PALETTES.light[body_colour(place)],
      });
    }
    first += body.vertices;
  });
  faces.sort((a, b) => b.depth - a.depth);
  const marks = contacts.map((contact) => {
    const [x, y] = at(contact.position);
    return contact.sticks
      ? svg("circle", { cx: x, cy: y, r: 1.8, fill: PALETTES.light.$s0 })
      : svg("path", { d: `M${x} ${y - 2.4}l2.4 2.4-2.4 2.4-2.4-2.400z`, fill: PALETTES.light.$s1 });
  });
  const [width, height] = [(right - left) * scale + 20, (bottom - top) * scale + 20];
  return svg(
    "svg",
    {
      class: "still",
      viewBox: `0 0 ${width} ${height}`,
      role: "img",
      "aria-label": "The recorded scene",
    },
    planes.map((points) =>
      svg("polygon", {
        points: points
          .map((point) =>
            at(point)
              .slice(0, 2)
              .map((x) => x.toFixed(1))
              .join(","),
          )
          .join(" "),
        class: "ground",
        fill: PALETTES.light.$grid,
        opacity: 0.6,
      }),
    ),
    faces.map(({ points, colour }) =>
      svg("polygon", {
        points: points.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(" "),
        fill: colour,
        stroke: "#1c2127",
        "stroke-width": 0.5,
        "stroke-linejoin": "round",
      }),
    ),
    marks,
  );
}
