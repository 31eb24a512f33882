// SPDX-License-Identifier: GPL-3.0-or-later
// Names beside the ends of curves, moved apart so that each can be read.

const LINE = 13; // px from name to name
const LEADER = 14; // px between the plot and the names

/**
 * Where to put names that would like to stand at `places` (px): as near as can be, in the same order,
 * `gap` apart, within [0, length].
 */
export function moved_apart(places, gap, length) {
  const order = places.map((place, i) => ({ place, i })).sort((a, b) => a.place - b.place);
  const room = Math.min(gap, order.length > 1 ? length / (order.length - 1) : gap);
  // Clusters of names that touch, each centred on where its names want to be.
  const clusters = [];
  for (const one of order) {
    clusters.push({ members: [one], centre: one.place });
    while (clusters.length > 0) {
      const last = clusters.at(-1);
      const half = (room * (last.members.length - 1)) / 2;
      last.centre = Math.max(half, Math.min(length - half, last.centre));
      const before = clusters.at(-2);
      if (!before) break;
      const start = last.centre - half;
      const end = before.centre + (room * (before.members.length - 1)) / 2;
      if (start - end >= room - 1e-9) break;
      clusters.splice(-2);
      const members = [...before.members, ...last.members];
      const centre = members.reduce((sum, { place }) => sum + place, 0) / members.length;
      clusters.push({ members, centre });
    }
  }
  const moved = new Array(places.length);
  for (const { members, centre } of clusters)
    members.forEach(({ i }, k) => (moved[i] = centre + room * (k - (members.length - 1) / 2)));
  return moved;
}

/** Where `y` stands on a logarithmic axis of `height`, px from the top. */
export const log_place = (y, domain, height) =>
  height *
  (1 -
    Math.log10(Math.min(domain[1], Math.max(domain[0], y)) / domain[0]) /
      Math.log10(domain[1] / domain[0]));

/** A channel in pixels. */
export const pixel = (field) => ({ field, type: "quantitative", scale: null, axis: null });

/** The places of names of things at `ys`, moved apart. */
export const name_places = (ys, domain, height) =>
  moved_apart(
    ys.map((y) => log_place(y, domain, height)),
    LINE,
    height,
  );

/** A height (px) at which `count` names can stand. */
export const height_for = (count, least) => Math.max(least, LINE * (count + 1));

/**
 * Layers that name curves at the right edge of a logarithmic plot. `ends`: [{name, y, …}] with the
 * fields of `color`; what else they have is for `tooltip`.
 */
export function end_labels(ends, { domain, height, color, tooltip }) {
  const moved = name_places(
    ends.map(({ y }) => y),
    domain,
    height,
  );
  const values = ends.map((end, i) => ({
    ...end,
    end_place: log_place(end.y, domain, height),
    label_place: moved[i],
  }));
  return [
    {
      data: { values },
      mark: { type: "rule", strokeWidth: 1, opacity: 0.7 },
      encoding: {
        x: { value: { expr: "width" } },
        x2: { value: { expr: `width + ${LEADER - 2}` } },
        y: pixel("end_place"),
        y2: { field: "label_place" },
        color,
      },
    },
    {
      data: { values },
      mark: { type: "text", align: "left", baseline: "middle", fontSize: 11, clip: false },
      encoding: {
        x: { value: { expr: `width + ${LEADER}` } },
        y: pixel("label_place"),
        text: { field: "name" },
        color,
        ...(tooltip && { tooltip }),
      },
    },
  ];
}
