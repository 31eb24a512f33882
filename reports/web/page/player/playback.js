// SPDX-License-Identifier: GPL-3.0-or-later
// Time of recordings that are shown together: pure functions.

/** The frame before `time` and how far the next one is along: {frame, part}. */
export function place_at(times, time) {
  if (time <= times[0]) return { frame: 0, part: 0 };
  let [low, high] = [0, times.length - 1];
  if (time >= times[high]) return { frame: high, part: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return { frame: low, part: (time - times[low]) / (times[high] - times[low]) };
}

/** Positions and the way up between two frames; contacts are those of the frame before. */
export function instant(recording, time) {
  const { frame, part } = place_at(recording.times, time);
  const before = recording.frame(frame);
  const up = recording.ups[frame];
  if (part === 0 || frame + 1 >= recording.times.length) return { ...before, up };
  const after = recording.frame(frame + 1).positions;
  const between = (a, b) => a.map((x, i) => x + part * (b[i] - x));
  return {
    positions: between(before.positions, after),
    contacts: before.contacts,
    up: between(up, recording.ups[frame + 1]),
  };
}

/**
 * Positions with displacements from those of a reference drawn `factor` times as large. What lies within
 * `step` (m, an axis), the fineness of the recording, has not moved.
 */
export function exaggerated(positions, reference, factor, step) {
  if (factor === 1) return positions;
  return positions.map((x, i) => {
    const way = x - reference[i];
    return Math.abs(way) <= 1.01 * step[i % 3] ? reference[i] : reference[i] + factor * way;
  });
}

/** The frame from which gravity stays: what came before is the scene being set up. 0 where it never does. */
export function settled_frame({ ups }) {
  let frame = ups.length - 1;
  while (frame > 0 && distance(ups[frame - 1], ups.at(-1)) < 1e-9) --frame;
  return frame < ups.length - 1 ? frame : 0;
}

// The box {centre, radius} around positions: an array of x, y, z, x, …
function ball_around(positions) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  return {
    centre: low.map((x, axis) => (x + high[axis]) / 2),
    radius: Math.max(1e-6, Math.hypot(...low.map((x, axis) => high[axis] - x)) / 2),
  };
}

const MOST_OUTER = 6; // times their own size: as far as bodies are followed
const MOST_APART = 1.5; // as much more of the scene that bursts is shown than of the calm one
const LARGE = 2.2; // times the others' size: what lies still and is that large is their ground

// The balls around each body in a frame, and where it begins among the positions.
function body_balls(recording, positions) {
  let first = 0;
  return recording.bodies.map(({ vertices }) => {
    const ball = ball_around(positions.subarray(3 * first, 3 * (first + vertices)));
    first += vertices;
    return ball;
  });
}

function ball_of_balls(balls) {
  const ends = balls.flatMap(({ centre, radius }) =>
    [-1, 1].map((side) => centre.map((x) => x + (side * radius) / Math.sqrt(3))),
  );
  return ball_around(Float64Array.from(ends.flat()));
}

const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));

// The bodies that one looks at: those that are no ground for the others.
function objects_of(starts, ends) {
  return starts
    .map((_, place) => place)
    .filter((place) => {
      const own = starts[place];
      const others = starts.filter((_, other) => other !== place);
      if (others.length === 0) return true;
      const lies_still = distance(own.centre, ends[place].centre) < 0.02 * own.radius;
      return !(lies_still && own.radius > LARGE * ball_of_balls(others).radius);
    });
}

// Around the objects from start to end; where they go far, around where they are at `moment`.
function ball_of(recording, moment) {
  const last = recording.times.length - 1;
  const at = (frame) => body_balls(recording, recording.frame(frame).positions);
  const [starts, ends] = [at(0), at(last)];
  const now = at(Math.min(last, place_at(recording.times, moment).frame));
  const objects = objects_of(starts, ends);
  const around = (...frames) =>
    ball_of_balls(objects.flatMap((place) => frames.map((balls) => balls[place])));
  const [whole, still] = [around(starts, now, ends), around(now)];
  const own = around(starts);
  if (whole.radius <= MOST_OUTER * Math.min(own.radius, still.radius))
    return { ...whole, far: false };
  return { centre: still.centre, radius: Math.min(1.3 * still.radius, 2 * own.radius), far: true };
}

// The median over frames of the largest force in each, N: an impact must not shrink all other arrows.
function typical_force(recording) {
  const largest = recording.times
    .map((_, i) =>
      recording
        .frame(i)
        .contacts.reduce(
          (most, { normal_force, friction_force }) =>
            Math.max(most, Math.hypot(...normal_force), Math.hypot(...friction_force)),
          0,
        ),
    )
    .filter((force) => force > 0)
    .sort((a, b) => a - b);
  return largest.length > 0 ? largest[largest.length >> 1] : 0;
}

/**
 * What recordings side by side share: {centre, radius} in m of what the camera shows, that is the bodies
 * without their ground, on their way unless they go far: then at `moment`, and the `force` in N that an arrow of ordinary length stands for:
 * the smaller one, so that a scene at rest shows its forces beside one that bursts.
 */
export function view_of(recordings, moment = Infinity) {
  const balls = recordings.map((recording) => ball_of(recording, moment));
  const staying = balls.filter(({ far }) => !far);
  const calm = (staying.length > 0 ? staying : balls).reduce((a, b) =>
    b.radius < a.radius ? b : a,
  );
  const widest = Math.max(...balls.map(({ radius }) => radius));
  const forces = recordings.map(typical_force).filter((force) => force > 0);
  return {
    centre: calm.centre,
    radius: Math.min(widest, MOST_APART * calm.radius),
    force: forces.length > 0 ? Math.min(...forces) : 0,
  };
}

// Of sizes: between two bodies a force and its reaction would cancel.
const sum_of = (contacts, field) =>
  contacts.reduce((sum, contact) => sum + Math.hypot(...contact[field]), 0);

/** Contacts in numbers: sticking, slipping, the sums of the forces' sizes in N. */
export function count_contacts(contacts) {
  const sticking = contacts.filter(({ sticks }) => sticks).length;
  return {
    sticking,
    slipping: contacts.length - sticking,
    normal: sum_of(contacts, "normal_force"),
    friction: sum_of(contacts, "friction_force"),
  };
}
