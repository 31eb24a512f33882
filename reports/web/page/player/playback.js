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

const MOST_OUTER = 6;

function ball_of(recording) {
  const start = ball_around(recording.frame(0).positions);
  const whole = ball_around([...recording.low, ...recording.high]);
  return whole.radius <= MOST_OUTER * start.radius
    ? whole
    : { centre: start.centre, radius: MOST_OUTER * start.radius };
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
 * What recordings side by side share: {centre, radius} in m of what the camera shows, that is the way of
 * all bodies unless something flies off, and the `force` in N that an arrow of ordinary length stands for:
 * the smaller one, so that a scene at rest shows its forces beside one that bursts.
 */
export function view_of(recordings) {
  const balls = recordings.map(ball_of);
  const forces = recordings.map(typical_force).filter((force) => force > 0);
  return {
    ...balls.reduce((a, b) => (b.radius > a.radius ? b : a)),
    force: forces.length > 0 ? Math.min(...forces) : 0,
  };
}

const sum_of = (contacts, field) =>
  Math.hypot(
    ...[0, 1, 2].map((axis) => contacts.reduce((sum, contact) => sum + contact[field][axis], 0)),
  );

/** Contacts in numbers: sticking, slipping, the sums of the forces in N. */
export function count_contacts(contacts) {
  const sticking = contacts.filter(({ sticks }) => sticks).length;
  return {
    sticking,
    slipping: contacts.length - sticking,
    normal: sum_of(contacts, "normal_force"),
    friction: sum_of(contacts, "friction_force"),
  };
}
