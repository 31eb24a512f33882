// SPDX-License-Identifier: GPL-3.0-or-later
// The specification of a sweep's picture, from its layout and what is drawn in each panel.
import { format_value, name_with_unit, with_unit } from "../model/number.js";
import { quantity_axis, rounded } from "./axes.js";
import { numbered, tip_number } from "./names.js";
import { HEIGHT } from "./sweep_layout.js";

// [low, high] of the cells whose middles are an axis' values.
function edges_of({ values, log }) {
  const [to, from] = log ? [Math.log, Math.exp] : [(value) => value, (value) => value];
  const at = values.map(to);
  const between = at.slice(1).map((value, i) => (value + at[i]) / 2);
  const ends = [2 * at[0] - between[0], ...between, 2 * at.at(-1) - between.at(-1)];
  const edges = ends.map(from).map(rounded);
  return values.map((_, i) => [edges[i], edges[i + 1]]);
}

/**
 * For a layout with cells: {of(place): the fields of their edges, for data as sweep_place() gives them, domains}.
 */
export function cells_of({ axes }) {
  const edges = axes.map((axis) => {
    const list = edges_of(axis);
    return new Map(axis.values.map((value, i) => [rounded(value), list[i]]));
  });
  return {
    of: (place) =>
      Object.fromEntries(
        axes.flatMap(({ field }, i) => {
          const [low, high] = edges[i].get(place[field]);
          return [
            [`edge_${field}_low`, low],
            [`edge_${field}_high`, high],
          ];
        }),
      ),
  };
}

// With room for marks at its ends; with cells exactly as far as these reach.
function axis_channel(axis, cells) {
  const channel = quantity_axis(axis.field, axis.name, axis.unit, { log: axis.log, grid: false });
  const ends = edges_of(axis);
  const room = cells ? { domain: [ends[0][0], ends.at(-1)[1]] } : { padding: 12 };
  return { ...channel, scale: { ...channel.scale, nice: false, ...room } };
}

/** The tooltip's lines for the values of all axes. */
export const axis_tips = ({ axes, facet }) =>
  [...axes, ...(facet ? [facet] : [])].map(({ field, name, unit }) =>
    tip_number(field, name_with_unit(name, unit)),
  );

// The encoding of a cell's rectangle.
const cell_channels = (x, y) => ({
  x: { ...x, field: `edge_${x.field}_low` },
  x2: { field: `edge_${x.field}_high` },
  y: { ...y, field: `edge_${y.field}_low` },
  y2: { field: `edge_${y.field}_high` },
});

/**
 * The specification over `values`. `unit({x, y}, cell)` gives a panel, mark and encoding or layers, from its
 * channels; `cell` has those of its rectangles where `cells` says that these are drawn.
 */
export function sweep_spec({ facet, pairs, panels }, values, unit, { cells = false } = {}) {
  const [first, ...others] = pairs.map((pair) => {
    const [x, y] = pair.map((axis) => axis_channel(axis, cells));
    return unit({ x, y }, cells && cell_channels(x, y));
  });
  const data = { values };
  if (panels === 1) return { height: HEIGHT, data, ...first };
  const usermeta = { panels };
  if (!facet)
    return {
      usermeta,
      data,
      concat: [first, ...others],
      resolve: { scale: { color: "shared", shape: "shared" } },
    };
  const words = facet.values.map(
    (value) => `${facet.name} = ${with_unit(format_value(value), facet.unit)}`,
  );
  const header = { title: null, labelExpr: numbered(words).labels };
  return { usermeta, data, facet: { field: "facet_key", type: "ordinal", header }, spec: first };
}
