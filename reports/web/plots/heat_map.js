// SPDX-License-Identifier: GPL-3.0-or-later
// A number over the axes of a sweep as colour: rectangles on a grid, else dots. What was not measured is marked,
// and never coloured.
import { format_count } from "../model/number.js";
import { tip } from "./names.js";
import { BAR } from "./palette.js";
import { drawn_of, mark_size, over_words, sweep_place, SWEEP_MARK } from "./sweep_layout.js";
import { axis_tips, cells_of, sweep_spec } from "./sweep_panels.js";

/** Why a point has no colour: words, colour, shape. */
const MISSING = [
  ["broke off", "$error", "diamond"],
  ["no finite number", "$ink", "cross"],
  ["not measured", "$na", BAR],
];
const column = (i) => MISSING.map((one) => one[i]);

// "4 broke off, 1 no finite number"
function missing_words(rows) {
  return column(0)
    .map((why) => [why, rows.filter(({ missing }) => missing === why).length])
    .filter(([, count]) => count > 0)
    .map(([why, count]) => `${format_count(count)} ${why}`)
    .join(", ");
}

const OVERLAP = 0.6; // px: closes the seams between cells
const CELL = {
  type: "rect",
  xOffset: -OVERLAP,
  x2Offset: OVERLAP,
  yOffset: OVERLAP,
  y2Offset: -OVERLAP,
  ...SWEEP_MARK,
};
const OUTLINED = 40; // px²: on smaller dots an outline would be all that is seen

const dot = (size) => ({
  type: "circle",
  size,
  opacity: 1,
  stroke: "$muted",
  strokeWidth: size < OUTLINED ? 0 : 0.4,
  ...SWEEP_MARK,
});

function layers({ scale, cells, size, tooltip }, channels, cell, lacking) {
  const measured = {
    mark: cells ? CELL : dot(size),
    encoding: { ...(cells ? cell : channels), color: scale.channel, tooltip },
  };
  if (lacking.length === 0) return measured;
  const marked = {
    transform: [{ filter: "datum.value === null" }],
    mark: {
      type: "point",
      filled: true,
      opacity: 1,
      size: Math.max(10, Math.min(60, size)),
      ...SWEEP_MARK,
    },
    encoding: {
      ...channels,
      fill: missing_channel(1, lacking),
      shape: missing_channel(2, lacking),
      tooltip,
    },
  };
  return { layer: [{ transform: [{ filter: "datum.value !== null" }], ...measured }, marked] };
}

const missing_channel = (i, lacking) => ({
  field: "missing",
  type: "nominal",
  scale: { domain: column(0), range: column(i) },
  legend: { values: lacking, orient: "bottom" },
});

/**
 * `points`: [{record, value, text, missing}]: what to colour, or null and why there is nothing, one of the words above;
 * `text` is the value as it is told. `scale` as colour_scale() gives it, `notes` are sentences for the caption.
 */
export function heat_map({ kind = "heat-map", title, points, layout, scale, notes, value_name }) {
  const { shown, words } = drawn_of(layout, points);
  const { cells } = layout;
  const edges = cells ? cells_of(layout) : null;
  const values = shown.flatMap(({ record, value, text, missing }) => {
    const place = sweep_place(layout, record);
    if (!place) return [];
    return {
      ...place,
      ...edges?.of(place),
      colour: value === null ? null : scale.of(value),
      value,
      ...(value === null && { missing }),
      told: text,
    };
  });
  const lacking = column(0).filter((why) => values.some(({ missing }) => missing === why));
  const tooltip = [...axis_tips(layout), tip("told", value_name)];
  const drawing = { scale, cells, size: mark_size(layout, values.length), tooltip };
  const sentence = (text) => text && `${text[0].toUpperCase()}${text.slice(1)}.`;
  return {
    kind,
    title: `${title} over ${over_words(layout)}`,
    wide: layout.panels > 1,
    caption: [...notes, scale.words, sentence(missing_words(points)), sentence(words)]
      .filter(Boolean)
      .join(" "),
    description: `${title} over ${over_words(layout)}, ${format_count(points.length)} points.`,
    spec: sweep_spec(layout, values, (channels, cell) => layers(drawing, channels, cell, lacking), {
      cells,
    }),
  };
}
