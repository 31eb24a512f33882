// SPDX-License-Identifier: GPL-3.0-or-later
// A ladder: error ÷ tolerance over the parameter, a line a configuration. Above, of each that breaks, a bar
// from the lowest to the highest rung that holds, and what is the first not to.
import { margin, short_margin } from "../model/check_text.js";
import { group_by } from "../model/family.js";
import { holds, ratio_of, rung_of, span_of, worse_of } from "../model/ladder.js";
import { VERDICT_WORDS, worst_check } from "../model/verdict.js";
import { parameter_places, ratio_places } from "./ladder_axes.js";
import { CROSS, LANE, lane_layers, lanes_of, span_words } from "./ladder_lanes.js";
import { tip } from "./names.js";
import { variant_channels } from "./variant_channels.js";

const HEIGHT = 170; // px, without the bars

const ENDLESS = short_margin(Infinity);

// One decided rung of a configuration.
function point_of({ record, rung }, variant_key, label, x, y) {
  const ratio = ratio_of(record);
  return {
    case: record.case,
    configuration: label,
    rung: rung.text,
    verdict: VERDICT_WORDS[record.verdict] ?? record.verdict,
    "error ÷ tolerance": short_margin(ratio),
    check: worst_check(record.checks, margin)?.quantity ?? record.error,
    place: y.place_of(ratio),
    x_key: x.place_of(rung.value),
    variant_key,
  };
}

// A line ends where a rung has no end: at ∞ there is nothing to join.
const joined = (point) =>
  point["error ÷ tolerance"] === ENDLESS ? { ...point, place: null } : point;

const plural = (count, word) => `${count} ${word}${count === 1 ? "" : "s"}`;

function caption_of(breaking, variants, lacking) {
  const throughout = variants.length - breaking.length;
  const all = variants.length > 1 ? `${throughout} of ${variants.length} hold` : "Holds";
  return [
    "Below the line a rung holds.",
    breaking.length > 0 && "Ringed: the last that holds; ✕: the first that does not.",
    throughout > 0 && `${all} on every rung.`,
    lacking > 0 && `${plural(lacking, "rung")} not applicable.`,
  ]
    .filter(Boolean)
    .join(" ");
}

// Of each rung the record that counts, in the order of the parameter.
const decided_rungs = (own) =>
  [...group_by(own, ({ rung }) => rung.text).values()]
    .map((same) => same.reduce((a, b) => (worse_of(a.record, b.record) === b.record ? b : a)))
    .map((one) => ({ ...one, value: one.rung.value, holds: holds(one.record) }))
    .filter((rung) => rung.holds !== null)
    .sort((a, b) => a.value - b.value);

function plot_of(entries, name_of, label_of) {
  const [{ rung: first }] = entries;
  const groups = [...group_by(entries, label_of)]
    .map(([label, own]) => ({
      label,
      configuration: name_of(own[0].record),
      rungs: decided_rungs(own),
    }))
    .filter(({ rungs }) => rungs.length > 0);
  const decided = groups.flatMap(({ rungs }) => rungs);
  if (decided.length === 0) return null;
  const texts = new Map(decided.map(({ rung }) => [rung.value, rung.text]));
  const x = parameter_places([...texts.keys()], (value) => texts.get(value));
  const y = ratio_places(decided.map(({ record }) => ratio_of(record)));
  const channels = variant_channels(groups);
  const several = groups.length > 1;
  const told = groups.map((group, variant_key) => {
    const span = span_of(group.rungs);
    const words = span_words(several ? group.label : "", span);
    const points = group.rungs.map((rung) => point_of(rung, variant_key, group.label, x, y));
    return { ...group, variant_key, span, words, points };
  });
  const breaking = told.filter(({ span }) => span.below || span.above);
  const decades = y.ceiling - y.floor;
  const lane = (LANE / HEIGHT) * (y.ceiling - y.floor);
  const lanes = lanes_of(breaking, x, y.ceiling, lane);
  const marked = (ends) =>
    told.flatMap(({ span, points }) =>
      ends(span).map((end) => points.find(({ rung }) => rung === end.rung.text)),
    );
  // Without a scale: the points alone make the legend; lines, rings and crosses would stand over their marks.
  const of_own = (range, value) => ({
    condition: range.map((own, key) => ({ test: `datum.variant_key === ${key}`, value: own })),
    value,
  });
  const place_axis = {
    field: "place",
    type: "quantitative",
    scale: { domain: [y.floor, y.ceiling + lanes.length * lane], nice: false },
    axis: { title: "error ÷ tolerance", ...y.ticks, gridOpacity: 0.7 },
  };
  const encoding = {
    x: {
      field: "x_key",
      type: "quantitative",
      scale: { domain: x.domain, nice: false, zero: false },
      axis: { title: `${first.parameter} `, ...x.ticks, grid: false, labelOverlap: "greedy" },
    },
    y: place_axis,
    color: of_own(channels.colours, "$ink"),
    tooltip: [
      tip("case", "case"),
      tip("configuration", "configuration"),
      tip("verdict", "verdict"),
      tip("error ÷ tolerance", "error ÷ tolerance"),
      tip("check", "check that decides"),
    ],
  };
  const { tooltip, ...bare } = encoding;
  const rect = (low, high, mark) => ({
    data: { values: [{ place: low, high }] },
    mark: { type: "rect", ...mark },
    encoding: { y: place_axis, y2: { field: "high" } },
  });
  const lacking = entries.filter(({ record }) => record.verdict === "not-applicable").length;
  const held = marked(({ lowest, highest, below, above }) =>
    [below && lowest, above && highest].filter(Boolean),
  );
  return {
    kind: "ladder",
    ladder: `${first.ladder}/${first.parameter}`,
    title: `${first.ladder} over ${first.parameter}`,
    caption: caption_of(breaking, told, lacking),
    description: `Error ÷ tolerance over ${first.parameter}. ${told.map(({ label, span }) => span_words(label, span)).join("; ")}`,
    spec: {
      height: HEIGHT + LANE * lanes.length,
      layer: [
        rect(y.floor, 0, { color: "$band", opacity: 0.6 }),
        ...(y.strip === null ? [] : [rect(y.strip, y.ceiling, { color: "$fail", opacity: 0.09 })]),
        {
          data: { values: [{ place: 0 }] },
          mark: { type: "rule", color: "$ink", strokeWidth: 1.25 },
          encoding: { y: place_axis },
        },
        ...(x.gap === null
          ? []
          : [
              {
                data: { values: [{ x_key: x.gap, place: y.floor, high: y.ceiling }] },
                mark: { type: "rule", color: "$axis", strokeDash: [2, 3] },
                encoding: { x: encoding.x, y: place_axis, y2: { field: "high" } },
              },
            ]),
        {
          data: { values: told.flatMap(({ points }) => points.map(joined)) },
          mark: { type: "line", strokeWidth: 1.4 },
          encoding: {
            ...bare,
            strokeDash: of_own(channels.dashes, [1, 0]),
            detail: { field: "variant_key" },
          },
        },
        {
          data: { values: told.flatMap(({ points }) => points) },
          mark: { type: "point", filled: true, size: 40, opacity: 1, cursor: "pointer" },
          encoding: {
            ...encoding,
            color: channels.channel(channels.colours),
            shape: channels.channel(channels.shapes),
          },
        },
        {
          data: { values: held },
          mark: { type: "point", size: 150, strokeWidth: 2, opacity: 1, cursor: "pointer" },
          encoding,
        },
        {
          data: { values: marked(({ below, above }) => [below, above].filter(Boolean)) },
          mark: { ...CROSS, size: 120 },
          encoding,
        },
        ...lane_layers(lanes, encoding),
      ],
    },
  };
}

/** The plots of a family's ladders. `entries`: [{record, run}]; `name_of` and `series_of` as for stability_of(). */
export function ladder_plots(entries, name_of, series_of) {
  const rungs = entries
    .map((entry) => ({ ...entry, rung: rung_of(entry.record.case) }))
    .filter(({ rung }) => rung);
  const ladders = group_by(rungs, ({ rung }) => `${rung.ladder}/${rung.parameter}`);
  return [...ladders.values()].map((group) => plot_of(group, name_of, series_of)).filter(Boolean);
}
