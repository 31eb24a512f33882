// SPDX-License-Identifier: GPL-3.0-or-later
// Colours by meaning. A specification names them ("$fail"); draw.js puts in those of the theme, so that
// one specification serves the light page, the dark page and the SVG file.
// Series colours are Okabe and Ito's, distinct for colour-blind readers; each also has its own dash.

import { VERDICT_WORDS } from "../model/verdict.js";

export const PALETTES = {
  light: {
    $ink: "#1c2127",
    $muted: "#59636e",
    $grid: "#e3e6ea",
    $axis: "#8d969f",
    $surface: "#ffffff",
    $band: "#e6f2ec",
    $pass: "#1b7f5c",
    $fail: "#c2330c",
    $limit: "#9a6700",
    $refuted: "#3d5a9e",
    $error: "#8b1a8b",
    $shown: "#5b6b7b",
    $na: "#8d969f",
    $score_least: "#a9dfc4",
    $score_middle: "#f4efd2",
    $score_most: "#f3b49a",
    $score_none: "#e3e6ea",
    $v0: "#440154",
    $v1: "#463480",
    $v2: "#355f8d",
    $v3: "#25848e",
    $v4: "#22a884",
    $v5: "#5ec962",
    $v6: "#bddf26",
    $s0: "#0072b2",
    $s1: "#d55e00",
    $s2: "#009e73",
    $s3: "#aa4499",
    $s4: "#b58900",
    $s5: "#3ba3d8",
    $s6: "#555555",
    $b0: "#c3ccd5",
    $b1: "#ddcfae",
    $b2: "#b3d3c0",
    $b3: "#dcbfd2",
    $b4: "#b9cbe6",
    $b5: "#e0c2b4",
  },
  dark: {
    $ink: "#e6e9ed",
    $muted: "#a3adb8",
    $grid: "#2c333b",
    $axis: "#68727d",
    $surface: "#14181d",
    $band: "#18332a",
    $pass: "#4cc39a",
    $fail: "#ff7a52",
    $limit: "#e0b13c",
    $refuted: "#9db7f5",
    $error: "#e58ae5",
    $shown: "#9fb0c0",
    $na: "#7b858f",
    $score_least: "#12583d",
    $score_middle: "#45421f",
    $score_most: "#7d3416",
    $score_none: "#2c333b",
    $v0: "#463480",
    $v1: "#365d8d",
    $v2: "#27808e",
    $v3: "#20a286",
    $v4: "#4dc26b",
    $v5: "#a1da38",
    $v6: "#fde725",
    $s0: "#58b4f0",
    $s1: "#ff9a52",
    $s2: "#3fd0a4",
    $s3: "#e08fd0",
    $s4: "#e6c34a",
    $s5: "#9adcff",
    $s6: "#bbbbbb",
    $b0: "#8d99a5",
    $b1: "#a8966a",
    $b2: "#6f9a82",
    $b3: "#a37f96",
    $b4: "#7f95b8",
    $b5: "#ab8470",
  },
};

export const SERIES_COLOURS = ["$s0", "$s1", "$s2", "$s3", "$s4", "$s5", "$s6"];
export const SERIES_DASHES = [
  [1, 0],
  [5, 4],
  [2, 3],
  [8, 3, 2, 3],
  [4, 4],
  [1, 3],
  [10, 2],
];
/** A bar, in Vega's square from −1 to 1: its own "stroke" is a line, of which a filled mark shows nothing. */
export const BAR = "M-1.2,-0.25H1.2V0.25H-1.2Z";

export const SERIES_SHAPES = [
  "circle",
  "square",
  "triangle-up",
  "diamond",
  "cross",
  "triangle-down",
  BAR,
];

/** The name of the i-th body's colour: pale, so that contacts and forces stand out. */
export const body_colour = (i) => `$b${i % 6}`;

// A saltire in Vega's square from −1 to 1, as in page/widgets/glyph.js.
const SALTIRE =
  "M-1,-0.6L-0.6,-1L0,-0.4L0.6,-1L1,-0.6L0.4,0L1,0.6L0.6,1L0,0.4L-0.6,1L-1,0.6L-0.4,0Z";

// Verdict, colour, shape.
const VERDICT_MARKS = [
  ["pass", "$pass", "circle"],
  ["fail", "$fail", "triangle-up"],
  ["expected-shortfall", "$limit", "triangle-down"],
  ["refuted", "$refuted", SALTIRE],
  ["error", "$error", "diamond"],
  ["for-information", "$shown", "square"],
  ["not-applicable", "$na", BAR],
];
export const VERDICT_DOMAIN = VERDICT_MARKS.map(([verdict]) => verdict);
const VERDICT_COLOURS = VERDICT_MARKS.map(([, colour]) => colour);
const VERDICT_SHAPES = VERDICT_MARKS.map(([, , shape]) => shape);

/** Vega-Lite's channels for verdicts: colour and shape say the same. */
export function verdict_encoding(legend) {
  const channel = (range) => ({
    field: "verdict",
    type: "nominal",
    scale: { domain: VERDICT_DOMAIN, range },
    legend,
  });
  return { color: channel(VERDICT_COLOURS), shape: channel(VERDICT_SHAPES) };
}

/** The words of model/verdict.js, in Vega's expressions. */
export const VERDICT_LABELS = `(${JSON.stringify(VERDICT_WORDS)})[datum.label]`;

/** The specification with the palette's colours; data and titles are left as they are. */
export function painted(value, palette) {
  if (typeof value === "string") return palette[value] ?? value;
  if (Array.isArray(value)) return value.map((entry) => painted(entry, palette));
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(
    Object.entries(value).map(([key, entry]) => [
      key,
      key === "data" || key === "title" || key === "description" ? entry : painted(entry, palette),
    ]),
  );
}
