// SPDX-License-Identifier: GPL-3.0-or-later
import { arrow, box_on, circle, ground, HEIGHT, label, line, polygon, WIDTH } from "./strokes.js";

export const matches = (name) => /^incline|^slab|slope|ramp/i.test(name);

// The slope that the case names, else a typical one: tan θ = 0.5.
function slope_of(name) {
  if (/level/.test(name)) return 0;
  const mu = /mu=([\d.]+)/.exec(name);
  return Math.min(0.9, mu ? Number(mu[1]) : 0.5);
}

/** A body on a slope, with weight, normal force, friction and the angle. */
export function draw(name) {
  const slope = slope_of(name);
  const angle = Math.atan(slope);
  const [left, right, base] = [24, WIDTH - 24, slope > 0 ? HEIGHT - 20 : HEIGHT - 44];
  const rise = Math.min(84, (right - left) * slope);
  const run = slope > 0 ? rise / slope : right - left;
  const x0 = (WIDTH - run) / 2;
  const top = base - rise;
  const middle = [x0 + 0.45 * run, top + 0.45 * rise];
  const { corners, centre, at } = box_on(middle[0], middle[1], angle, 44, 26);
  const point = /point/.test(name);
  const middle_of_body = point ? at(0, 6) : centre;
  const moving = /sliding|above|stop|acceler|level|critical\/speed/.test(name);
  const level = slope === 0;
  return [
    level
      ? ground(left, base, right, base)
      : [...ground(x0, top, x0 + run, base), line(x0, base, x0 + run, base, "thin")],
    point ? circle(...middle_of_body, 6) : polygon(corners),
    arrow(...middle_of_body, 0, 30, "weight"),
    arrow(...middle_of_body, ...from_to(at(0, 0), at(0, 30)), "force"),
    arrow(...at(-22, 2), ...from_to(at(0, 0), at(-26, 0)), "friction"),
    moving && arrow(...at(-14, point ? 22 : 36), ...from_to(at(0, 0), at(34, 0)), "motion"),
    !level && label(x0 + run - 34, base - 5, "θ"),
  ];
}

const from_to = (a, b) => [b[0] - a[0], b[1] - a[1]];
