// SPDX-License-Identifier: GPL-3.0-or-later
// What precision costs with each engine: the error of its answers to a question over CPU time, with each
// effort of its ladder, joined by their cost: a configuration's usual one may lie amid the ladder. A colour for each engine, a shape for each of its configurations; other builds of an engine are dotted.
import { failed_efforts } from "../model/engine_answer.js";
import { log_domain, quantity_axis, rounded } from "./axes.js";
import { pixel } from "./end_labels.js";
import { failed_lines, looks_of, points_of } from "./engine_work_points.js";
import { BY_MACHINE, fronts_by_machine } from "./machine_marks.js";
import { numbered, tip, tip_number } from "./names.js";

const HEIGHT = 380; // px
const MOST_NAMED = 5; // of the front, in the caption

const edge_words = (told) =>
  [
    told.some(({ error }) => error === 0) && "On the lower edge: no error at all.",
    told.some(({ error }) => Number.isNaN(error)) &&
      "On the upper edge: it never came to what is asked for.",
  ].filter(Boolean);

/** `all`: [{variant, record}] of a case engines/…; null where no engine has a curve. */
export function engine_work_plot(all) {
  const entries = all.filter(
    ({ record }) => record.series.length > 0 || failed_efforts(record).length > 0,
  );
  const points = entries.flatMap(points_of);
  if (points.length === 0) return null;
  const unit = entries.find(({ record }) => record.series.length > 0).record.series[0].unit;
  const x_domain = log_domain(points.map(({ seconds }) => seconds));
  const y_domain = log_domain(points.map(({ error }) => error));
  if (points.some(({ error }) => Number.isNaN(error))) y_domain[1] *= 10; // above all that is told
  const names = numbered(entries.map(({ variant }) => variant.name));
  const looks = looks_of(entries);
  const place = (point) => ({
    ...point,
    seconds: rounded(Math.max(x_domain[0], point.seconds)),
    y: rounded(
      Number.isNaN(point.error)
        ? y_domain[1]
        : Math.min(y_domain[1], Math.max(y_domain[0], point.error)),
    ),
    error: Number.isNaN(point.error) ? "never" : point.error,
  });
  const front = fronts_by_machine(
    points.filter(({ error }) => Number.isFinite(error)),
    ({ seconds }) => seconds,
    ({ error }) => error,
  );
  const channel = (range, legend) => ({
    field: "who_key",
    type: "ordinal",
    scale: { domain: names.keys, range },
    legend: legend && { labelExpr: names.labels },
  });
  const color = channel(
    looks.map((look) => look.color),
    true,
  );
  const encoding = {
    x: quantity_axis("seconds", "CPU time", "s", { log: true, domain: x_domain }),
    y: quantity_axis("y", "|error|", unit, { log: true, domain: y_domain }),
  };
  const tooltip = [
    tip("who", "engine"),
    tip("effort", "effort"),
    tip_number("seconds", "CPU s"),
    tip("error", "|error|"),
  ];
  const failed = failed_lines(entries);
  const all_failed = entries.reduce((sum, { record }) => sum + failed_efforts(record).length, 0);
  const on_front = [...new Set(front.map(({ who }) => who))];
  const front_words =
    on_front.slice(0, MOST_NAMED).join(", ") + (on_front.length > MOST_NAMED ? ", …" : "");
  return {
    kind: "work-precision",
    title: "Work and precision, engine by engine",
    wide: true,
    caption: [
      `Lower left is better. Dashed: what no other beats: ${front_words}.`,
      "Lines join an engine's efforts by their cost; filled: its usual one.",
      points.some(({ build }) => build) &&
        "Dotted: another build of the same engine, such as in single precision.",
      ...edge_words(points),
      all_failed > 0 && `✕: ${all_failed} answer${all_failed > 1 ? "s" : ""} failed.`,
    ]
      .filter(Boolean)
      .join(" "),
    description:
      `Error over CPU time of ${entries.length} engines and configurations, ${points.length} points. ` +
      `None is beaten by another: ${front_words}.`,
    spec: {
      height: HEIGHT,
      layer: [
        {
          data: { values: front.map(place) },
          mark: {
            type: "line",
            color: "$muted",
            strokeDash: [5, 4],
            strokeWidth: 1.5,
            interpolate: "step-after",
          },
          encoding: { ...encoding, detail: BY_MACHINE },
        },
        {
          data: { values: points.map(place) },
          mark: { type: "line", opacity: 0.8 },
          encoding: {
            ...encoding,
            color,
            order: { field: "seconds", type: "quantitative" },
            strokeWidth: {
              field: "ours",
              type: "nominal",
              scale: { domain: [false, true], range: [1.4, 2.6] },
              legend: null,
            },
            strokeDash: {
              field: "build",
              type: "nominal",
              scale: { domain: [false, true], range: [[], [3, 3]] },
              legend: null,
            },
          },
        },
        {
          data: { values: points.map(place) },
          mark: { type: "point", size: 62, strokeWidth: 1.7, opacity: 1 },
          encoding: {
            ...encoding,
            stroke: color,
            fill: { ...color, legend: null },
            shape: channel(
              looks.map((look) => look.shape),
              true,
            ),
            fillOpacity: { condition: { test: "datum.effort === 0", value: 1 }, value: 0 },
            tooltip,
          },
        },
        {
          data: { values: failed },
          mark: { type: "text", align: "right", baseline: "middle", fontSize: 10.5, dx: -3 },
          encoding: {
            x: { value: { expr: "width" } },
            y: pixel("place"),
            text: { field: "name" },
            color: { ...color, legend: null },
            tooltip: [tip("who", "engine"), tip("failure", "failed")],
          },
        },
      ],
    },
  };
}
