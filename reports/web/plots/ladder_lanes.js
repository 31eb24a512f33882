// SPDX-License-Identifier: GPL-3.0-or-later
// Above a ladder's curves: of each configuration that breaks a bar from the lowest to the highest rung that
// holds, crosses at the first that do not, and that in words.
import { tip } from "./names.js";

export const LANE = 27; // px a bar with its words

/** A mark of what breaks. */
export const CROSS = {
  type: "point",
  shape: "cross",
  angle: 45,
  filled: true,
  opacity: 1,
  cursor: "pointer",
};

/** "quiet: holds 2 … 10, breaks at 20" of a span as span_of() gives it. */
export function span_words(label, { lowest, highest, below, above }) {
  const held = lowest
    ? `holds ${lowest === highest ? lowest.rung.text : `${lowest.rung.text} … ${highest.rung.text}`}`
    : "no rung holds";
  const broken = [below, above].filter((end) => end && lowest).map(({ rung }) => rung.text);
  const words = broken.length > 0 ? `${held}, breaks at ${broken.join(" and ")}` : held;
  return label ? `${label}: ${words}` : words;
}

/** Where the bars of `breaking`, [{words, span, variant_key}], stand: from `top` upwards, `lane` decades apart. */
export function lanes_of(breaking, x, top, lane) {
  const at = (end) => end && x.place_of(end.rung.value);
  return breaking.map(({ words, span, variant_key }, i) => ({
    variant_key,
    words,
    text_key: top + lane * (breaking.length - i - 0.3),
    place: top + lane * (breaking.length - i - 0.75),
    low_key: at(span.lowest),
    high_key: at(span.highest),
    broken: [span.below, span.above]
      .filter(Boolean)
      .map((end) => ({ x_key: at(end), case: end.record.case })),
  }));
}

/** The layers that draw them; `encoding` are the channels of the curves. */
export function lane_layers(lanes, { x, y, color }) {
  const tooltip = [tip("words", "ladder")];
  const ends = lanes.flatMap(({ broken, place, variant_key, words }) =>
    broken.map((end) => ({ ...end, place, variant_key, words })),
  );
  return [
    {
      data: { values: lanes.filter(({ low_key }) => low_key !== null) },
      mark: { type: "rule", strokeWidth: 5, opacity: 0.8, strokeCap: "round" },
      encoding: { x: { ...x, field: "low_key" }, x2: { field: "high_key" }, y, color, tooltip },
    },
    {
      data: { values: ends },
      mark: { ...CROSS, size: 80 },
      encoding: { x, y, color, tooltip },
    },
    {
      data: { values: lanes },
      mark: {
        type: "text",
        align: "left",
        baseline: "middle",
        dx: 4,
        color: "$ink",
        limit: { expr: "width - 8" },
      },
      encoding: { x: { value: 0 }, y: { ...y, field: "text_key" }, text: { field: "words" } },
    },
  ];
}
