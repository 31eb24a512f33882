// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * The power law y = factor · x^exponent that fits best in the logarithms (least squares), with the share of
 * the variance that it explains; null when fewer than two points with different x are positive.
 */
export function power_law(points) {
  const logs = points
    .filter(({ x, y }) => x > 0 && y > 0)
    .map(({ x, y }) => [Math.log(x), Math.log(y)]);
  if (logs.length < 2) return null;
  const mean = (place) => logs.reduce((sum, one) => sum + one[place], 0) / logs.length;
  const [mean_x, mean_y] = [mean(0), mean(1)];
  let covariance = 0;
  let variance = 0;
  let spread = 0;
  for (const [x, y] of logs) {
    covariance += (x - mean_x) * (y - mean_y);
    variance += (x - mean_x) ** 2;
    spread += (y - mean_y) ** 2;
  }
  if (variance === 0) return null;
  const exponent = covariance / variance;
  const explained = spread > 0 ? (exponent * covariance) / spread : 1;
  return { exponent, factor: Math.exp(mean_y - exponent * mean_x), explained };
}

const LEAST_POINTS = 3;
const EXPLAINED = 0.99;
const SPAN = 2; // largest ÷ smallest: what hardly changes has no exponent to tell

const is_monotone = (values) =>
  values.every((y, i) => i === 0 || y >= values[i - 1]) ||
  values.every((y, i) => i === 0 || y <= values[i - 1]);

/** power_law() where the points follow one: three or more, rising or falling all the way by
 * a factor worth telling, near the line. */
export function clear_power_law(points) {
  const positive = points.every(({ x, y }) => x > 0 && y > 0);
  if (!positive || new Set(points.map(({ x }) => x)).size < LEAST_POINTS) return null;
  const ys = points.map(({ y }) => y);
  if (Math.max(...ys) < SPAN * Math.min(...ys)) return null;
  const in_order = [...points].sort((a, b) => a.x - b.x).map(({ y }) => y);
  const fit = is_monotone(in_order) ? power_law(points) : null;
  return fit && fit.explained >= EXPLAINED ? fit : null;
}

/** The points that no other beats in both: none is as cheap and as precise, and better in one. */
export function pareto_front(points, cost_of, error_of) {
  const front = [];
  const sorted = [...points].sort((a, b) => cost_of(a) - cost_of(b) || error_of(a) - error_of(b));
  for (const point of sorted) {
    if (front.length === 0 || error_of(point) < error_of(front.at(-1))) front.push(point);
  }
  return front;
}
