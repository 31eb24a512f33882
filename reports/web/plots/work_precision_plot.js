// SPDX-License-Identifier: GPL-3.0-or-later
// What precision costs: error ÷ tolerance of each record's worst check over its CPU time. A line at 1 is the
// tolerance; what broke off stands in a strip of its own; a line joins the efforts of a configuration in a
// case; large marks are configurations over the cases that all of them ran.
import { configuration_of, ordered_configurations } from "../model/configuration.js";
import { format_count, to_number } from "../model/number.js";
import { machine_names, timings_sentence } from "../model/machine.js";
import { variant_styles } from "./configuration_style.js";
import { log_domain, quantity_axis, rounded } from "./axes.js";
import { numbered, tip, tip_number } from "./names.js";
import { effort_groups, shared_cases_of, shared_sums, work_points } from "../model/work.js";

const DECADES = 6; // shown on either side of the tolerance
const BROKEN = DECADES + 1.6; // where the strip of what broke off is
const STRIP = [DECADES + 0.8, DECADES + 2.4];
const MOST_MARKS = 1500;
const TELLING = 2;
const BIG = 240; // px²
const SMALL = 34;

const place_of = ({ ratio, broke }) => {
  if (broke) return BROKEN;
  const decades = ratio > 0 ? Math.log10(ratio) : -Infinity;
  return rounded(Math.min(DECADES, Math.max(-DECADES, decades)));
};

// Of very many, those of one configuration at about the same place are one mark, with the worst one's case.
function thinned(marks) {
  for (let per_decade = 20; marks.length > MOST_MARKS && per_decade >= 2; per_decade /= 2) {
    const bins = new Map();
    for (const mark of marks) {
      const cell = (value) => Math.round(value * per_decade);
      const key = `${mark.configuration} ${cell(Math.log10(mark.seconds))} ${cell(mark.place)} ${mark.judged}`;
      const bin = bins.get(key);
      if (bin) bin.records += mark.records;
      else bins.set(key, { ...mark });
    }
    marks = [...bins.values()];
  }
  return marks.slice(0, MOST_MARKS);
}

const ratio_text = ({ broke, ratio }) =>
  broke ? "broke off" : ratio === 0 ? "exact" : `${Number(ratio.toPrecision(2))} × tolerance`;

const Y_TICKS = [-6, -4, -2, 0, 2, 4, 6, BROKEN];
const Y_LABELS =
  `datum.value > ${DECADES} ? 'broke off' : datum.value == ${DECADES} ? '≥ 1e6' : ` +
  `datum.value == -${DECADES} ? '≤ 1e-6' : datum.value == 0 ? '1' : '1e' + datum.value`;

function words(points, shared, unjudged, untimed, lines, one) {
  return [
    "Below the line a record holds; left is cheaper.",
    shared.sums.length > 0 &&
      `Large: each of ${shared.sums.length} configurations over the ${format_count(shared.cases)} case${shared.cases === 1 ? "" : "s"} that all of them ran (sum of CPU time, worst ratio).`,
    lines > 0 && "Lines join the efforts of one configuration in one case.",
    unjudged > 0 && "Hollow: for information, judged by nobody.",
    untimed > 0 && `${format_count(untimed)} without CPU time are left out.`,
    one && "Marks are several records where they lie close together.",
  ]
    .filter(Boolean)
    .join(" ");
}

// Whether points differ enough to make a picture: in what they cost or in how precise they are.
function is_spread(points) {
  const spread = (values) =>
    values.reduce((a, b) => Math.max(a, b), 0) / values.reduce((a, b) => Math.min(a, b), Infinity);
  const of = (value_of) => points.map(value_of).filter((value) => value > 0);
  return (
    spread(of(({ seconds }) => seconds)) >= TELLING || spread(of(({ ratio }) => ratio)) >= TELLING
  );
}

/**
 * The plot of some records. Null when nothing was both timed and measured, or, but for `always`, when all lies
 * on one spot. `name_of(record)` is what a record's configuration is called.
 */
export function work_precision_plot(
  records,
  { name_of = configuration_of, height = 260, always = false } = {},
) {
  const is_timed = ({ cost }) => to_number(cost.cpu_seconds) > 0;
  const with_machine = machine_names(records.filter(is_timed));
  const series_of = (record) => with_machine(name_of(record), record);
  const all = work_points(records, series_of);
  const points = all.filter(({ seconds }) => seconds > 0);
  if (points.length === 0 || (!always && !is_spread(points))) return null;
  const configurations = new Map(
    points.map(({ configuration, record }) => [configuration, name_of(record)]),
  );
  const order = ordered_configurations(configurations.values());
  const names = [...configurations.keys()].sort(
    (a, b) =>
      order.indexOf(configurations.get(a)) - order.indexOf(configurations.get(b)) ||
      (a < b ? -1 : 1),
  );
  const styles = variant_styles(names.map((name) => configurations.get(name)));
  const keys = numbered(names);
  const shared = shared_sums(points, shared_cases_of(records, series_of));
  const shown = (point) => ({
    case: point.case,
    configuration: point.configuration,
    configuration_key: keys.key_of(point.configuration),
    seconds: rounded(point.seconds),
    place: place_of(point),
    "error ÷ tolerance": ratio_text(point),
    check: point.quantity,
    judged: point.judged,
    records: 1,
  });
  const marks = thinned(points.map(shown));
  const lines = effort_groups(points).flatMap((group, line_key) =>
    group.map((point) => ({ ...shown(point), line_key })),
  );
  const sums = shared.sums.map((point) => ({ ...shown(point), check: "worst of these" }));
  const channel = (range, legend) => ({
    field: "configuration_key",
    type: "ordinal",
    scale: { domain: keys.keys, range },
    legend,
  });
  const legend = names.length > 1 ? { labelExpr: keys.labels } : null;
  const look = (field) => styles.map((style) => style[field]);
  const encoding = {
    x: quantity_axis("seconds", "CPU time", "s", {
      log: true,
      domain: log_domain([...marks, ...sums].map(({ seconds }) => seconds)),
    }),
    y: {
      field: "place",
      type: "quantitative",
      scale: { domain: [-DECADES - 0.3, STRIP[1]], nice: false },
      axis: {
        title: "error ÷ tolerance",
        values: Y_TICKS,
        labelExpr: Y_LABELS,
        gridOpacity: 0.7,
      },
    },
    color: channel(look("colour"), legend),
    shape: channel(look("shape"), legend),
    tooltip: [
      tip("case", "case"),
      tip("configuration", "configuration"),
      tip("error ÷ tolerance", "error"),
      tip("check", "worst check"),
      tip_number("seconds", "CPU s"),
    ],
  };
  const y = encoding.y;
  const unjudged = marks.filter(({ judged }) => !judged).length;
  const point = { type: "point", size: SMALL, strokeWidth: 1.4, cursor: "pointer" };
  return {
    title: "Precision and what it costs",
    caption: [
      words(
        points,
        shared,
        unjudged,
        all.length - points.length,
        lines.length,
        marks.some(({ records: count }) => count > 1),
      ),
      timings_sentence(points.map(({ record }) => record)),
    ]
      .filter(Boolean)
      .join(" "),
    description: `Error ÷ tolerance over CPU time of ${points.length} records; ${points.filter(({ broke }) => broke).length} broke off.`,
    spec: {
      height,
      layer: [
        {
          data: { values: [{ low: STRIP[0], high: STRIP[1] }] },
          mark: { type: "rect", color: "$fail", opacity: 0.09 },
          encoding: { y: { ...y, field: "low" }, y2: { field: "high" } },
        },
        {
          data: { values: [{ low: -DECADES - 0.3, high: 0 }] },
          mark: { type: "rect", color: "$band", opacity: 0.6 },
          encoding: { y: { ...y, field: "low" }, y2: { field: "high" } },
        },
        {
          data: { values: [{ place: 0, text: "tolerance" }] },
          mark: { type: "rule", color: "$ink", strokeWidth: 1.25 },
          encoding: { y },
        },
        {
          data: { values: [{ place: 0, text: "tolerance" }] },
          mark: { type: "text", align: "left", baseline: "bottom", dx: 3, dy: -2, color: "$ink" },
          encoding: { x: { value: 0 }, y, text: { field: "text" } },
        },
        ...(lines.length > 0
          ? [
              {
                data: { values: lines },
                mark: { type: "line", strokeWidth: 1.2, opacity: 0.7 },
                encoding: {
                  x: encoding.x,
                  y,
                  color: encoding.color,
                  detail: { field: "line_key" },
                },
              },
            ]
          : []),
        ...(sums.length > 0
          ? [
              {
                data: { values: sums },
                mark: {
                  type: "point",
                  filled: true,
                  size: BIG,
                  opacity: 1,
                  stroke: "$surface",
                  strokeWidth: 1.5,
                },
                encoding: { ...encoding, tooltip: encoding.tooltip },
              },
            ]
          : []),
        {
          data: { values: marks.filter(({ judged }) => judged) },
          mark: { ...point, filled: true, opacity: 0.6 },
          encoding,
        },
        ...(unjudged > 0
          ? [
              {
                data: { values: marks.filter(({ judged }) => !judged) },
                mark: { ...point, filled: false, opacity: 0.8 },
                encoding,
              },
            ]
          : []),
      ],
    },
  };
}
