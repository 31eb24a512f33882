// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines in a plane: hulls, pieces of them, hatching. Points are [x, y].

/** The convex hull of points, counter-clockwise where y points up. */
export function hull_of(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  if (sorted.length < 3) return sorted;
  const turn = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  const half = (list) => {
    const chain = [];
    for (const point of list) {
      while (chain.length >= 2 && turn(chain.at(-2), chain.at(-1), point) <= 0) chain.pop();
      chain.push(point);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

/** The part of a convex polygon where side(point) ≥ 0; `side` is linear. */
export function cut(polygon, side) {
  return polygon.flatMap((b, i) => {
    const a = polygon.at(i - 1);
    const [s, t] = [side(a), side(b)];
    const crosses = s >= 0 !== t >= 0;
    const between = crosses
      ? [[a[0] + ((b[0] - a[0]) * s) / (s - t), a[1] + ((b[1] - a[1]) * s) / (s - t)]]
      : [];
    return t >= 0 ? [...between, b] : between;
  });
}

export const cut_to_box = (polygon, [left, top, right, bottom]) =>
  [([x]) => x - left, ([x]) => right - x, ([, y]) => y - top, ([, y]) => bottom - y].reduce(
    (rest, side) => (rest.length > 0 ? cut(rest, side) : rest),
    polygon,
  );

/** The ends of what of the line through `point` along `way` lies in a convex polygon; null when nothing. */
export function chord(polygon, point, way) {
  let [from, to] = [-Infinity, Infinity];
  const middle = polygon
    .reduce(([x, y], p) => [x + p[0], y + p[1]], [0, 0])
    .map((x) => x / polygon.length);
  for (let i = 0; i < polygon.length; ++i) {
    const [a, b] = [polygon.at(i - 1), polygon[i]];
    let normal = [b[1] - a[1], a[0] - b[0]];
    const inside = normal[0] * (middle[0] - a[0]) + normal[1] * (middle[1] - a[1]);
    if (inside < 0) normal = [-normal[0], -normal[1]];
    const distance = normal[0] * (point[0] - a[0]) + normal[1] * (point[1] - a[1]);
    const slope = normal[0] * way[0] + normal[1] * way[1];
    if (Math.abs(slope) < 1e-12) {
      if (distance < 0) return null;
    } else if (slope > 0) from = Math.max(from, -distance / slope);
    else to = Math.min(to, -distance / slope);
  }
  return to - from > 1e-9
    ? [from, to].map((t) => [point[0] + t * way[0], point[1] + t * way[1]])
    : null;
}

/** Parallel lines at 45° over a convex polygon: [[a, b]]. */
export function hatching(polygon, spacing) {
  if (polygon.length < 3) return [];
  const way = [Math.SQRT1_2, -Math.SQRT1_2];
  const along = ([x, y]) => (x + y) * Math.SQRT1_2;
  const places = polygon.map(along);
  const [low, high] = [Math.min(...places), Math.max(...places)];
  const lines = [];
  for (let at = low + spacing / 2; at < high && lines.length < 300; at += spacing) {
    const line = chord(polygon, [at * Math.SQRT1_2, at * Math.SQRT1_2], way);
    if (line) lines.push(line);
  }
  return lines;
}
