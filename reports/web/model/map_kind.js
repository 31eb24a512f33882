// SPDX-License-Identifier: GPL-3.0-or-later

/** Kinds of plots that colour each point of a sweep: large, and not needed before one asks for them. */
export const MAP_KINDS = ["heat-map", "sweep-cost"];

export const is_map = ({ kind }) => MAP_KINDS.includes(kind);
