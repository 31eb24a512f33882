// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of three as arrays, and unit quaternions w, x, y, z.

export const add = (a, b) => a.map((x, i) => x + b[i]);
export const subtract = (a, b) => a.map((x, i) => x - b[i]);
export const scaled = (a, factor) => a.map((x) => factor * x);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const size_of = (a) => Math.hypot(...a);
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Null for a vector without length. */
export function unit(a) {
  const size = size_of(a);
  return size > 0 ? scaled(a, 1 / size) : null;
}

/** The part of `a` at right angles to the unit vector `n`. */
export const across = (a, n) => subtract(a, scaled(n, dot(a, n)));

/** `a` turned by the quaternion `q`. */
export function turned([w, ...v], a) {
  const t = scaled(cross(v, a), 2);
  return add(add(a, scaled(t, w)), cross(v, t));
}
