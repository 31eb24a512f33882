// SPDX-License-Identifier: GPL-3.0-or-later
// Work and precision of a comparison whose cases differ in parameters only and measure their own CPU
// time: the first other figure over it. A line joins a variant's cases along the last parameter; what
// failed stands at the upper edge.
import { compared_quantities, failure_of, figure_of, WORK } from "../model/figure.js";
import { group_by, short_name } from "../model/family.js";
import { machine_letter } from "../model/machine.js";
import { format_seconds, to_number } from "../model/number.js";
import { log_domain, quantity_axis, rounded } from "./axes.js";
import { end_labels, height_for, name_places, pixel } from "./end_labels.js";
import { BY_MACHINE, fronts_by_machine } from "./machine_marks.js";
import { tip, tip_number } from "./names.js";
import { SERIES_SHAPES } from "./palette.js";
import { rule_channels } from "./rule_channels.js";

const HEIGHT = 340; // px
const ROOM = 7; // times the least CPU time is left free for the names of the front
const TELLING = 2; // a point of the front is named when its error is this much below the last named
const is_parameter = (part) => /^[^=]+=[^=]+$/.test(part);

// {line, at}: the parameters but the last, and the last.
function place_in_family(case_name) {
  const parts = short_name(case_name).split("/");
  return { line: parts.slice(0, -1).join(" "), at: parts.at(-1) };
}

/** Whether `records`, those of a family, are such a comparison. */
export function is_rule_work(records) {
  const measured = records.filter(({ figures }) => figures.length > 0);
  return (
    measured.length > 0 &&
    new Set(records.map((record) => record.case)).size > 1 &&
    records.every((record) => short_name(record.case).split("/").every(is_parameter)) &&
    measured.every((record) => compared_quantities([record]).some((one) => one.quantity === WORK))
  );
}

function points_of(entries, precision) {
  return entries.map(({ record, variant }) => {
    const work = figure_of(record, WORK);
    const seconds = Number.isFinite(work) ? work : to_number(record.cost.cpu_seconds);
    const error = figure_of(record, precision);
    const failure = failure_of(record) || (Number.isFinite(error) ? "" : "did not get there");
    const machine = machine_letter(record);
    return {
      variant,
      machine,
      case: record.case,
      ...place_in_family(record.case),
      seconds,
      error,
      failure,
    };
  });
}

function axes_of(points, precision, work) {
  const seconds = points.map((point) => point.seconds).filter((value) => value > 0);
  const [low, high] = [Math.min(...seconds), Math.max(...seconds)];
  const range =
    seconds.length > 0 ? { low: low * 0.85, high: high * 1.15 } : { low: 1e-3, high: 1 };
  const y_domain = log_domain(points.map(({ error }) => error));
  const y = quantity_axis("y", precision.quantity, precision.unit, { log: true, domain: y_domain });
  // Room for the names of the front, where no point can be.
  const x = (room) =>
    quantity_axis("x", WORK, work.unit, { log: true, domain: [range.low / room, range.high] });
  return { x, y, y_domain, range, unit: work.unit };
}

const words_of = ({ variant }) => [variant.name, variant.contacts].filter(Boolean).join(", ");

function rows_of(points, channels, { range, y_domain }) {
  return points.map((point) => ({
    who: words_of(point),
    machine: point.machine,
    ...channels.keys_of(point.variant),
    line_key: `${words_of(point)} ${point.line}`,
    case: point.case,
    // What was never timed stands at the right edge, what failed at the upper one.
    x: rounded(point.seconds > 0 ? point.seconds : range.high),
    y: point.failure ? y_domain[1] : rounded(Math.max(y_domain[0], point.error)),
    failure: point.failure,
  }));
}

function layers(rows, encoding, channels, unit, overall_view) {
  const tooltip = [
    tip("who", "rule"),
    tip("case", "case"),
    tip_number("x", `CPU ${unit}`),
    tip_number("y", encoding.y.axis.title.trim()),
  ];
  const held = rows.filter(({ failure }) => !failure);
  const failed = rows.filter(({ failure }) => failure);
  const machines = [...new Set(rows.map(({ machine }) => machine))].sort();
  const shape = {
    ...BY_MACHINE,
    type: "nominal",
    scale: { domain: machines, range: SERIES_SHAPES },
    legend: machines.length > 1 ? { symbolFillColor: "$ink", symbolStrokeColor: "$ink" } : null,
  };
  const filled = {
    field: "contacts_key",
    type: "ordinal",
    scale: {
      domain: channels.contacts.map((_, i) => i),
      range: channels.contacts.map((_, i) => (i === 0 ? 0 : 1)),
    },
    legend: null,
  };
  return [
    {
      data: { values: held },
      mark: { type: "line", strokeWidth: overall_view ? 1 : 1.6, opacity: overall_view ? 0.5 : 1 },
      encoding: {
        ...encoding,
        color: overall_view ? channels.named_color : channels.color,
        strokeDash: channels.dash,
        detail: { field: "line_key" },
      },
    },
    {
      data: { values: held },
      mark: {
        type: "point",
        size: overall_view ? 34 : 46,
        strokeWidth: 1.6,
        opacity: 1,
        cursor: "pointer",
      },
      encoding: {
        ...encoding,
        stroke: channels.color,
        fill: channels.color,
        shape,
        fillOpacity: filled,
        tooltip,
      },
    },
    {
      data: { values: failed },
      mark: { type: "point", shape: "cross", angle: 45, filled: true, size: 80, opacity: 1 },
      encoding: {
        ...encoding,
        color: channels.color,
        tooltip: [...tooltip.slice(0, 3), tip("failure", "failed")],
      },
    },
  ];
}

const marks_words = (contacts, failed) =>
  [
    contacts.length > 1 &&
      `Hollow: ${contacts[0]} contacts; filled: ${contacts.slice(1).join(", ")}.`,
    failed > 0 ? `✕ at the upper edge: ${failed} failed.` : "None failed.",
  ]
    .filter(Boolean)
    .join(" ");

// All points, with the front and the names of those on it.
function overall(rows, channels, axes, precision, at) {
  const candidates = rows.filter(({ failure }) => !failure);
  const front = fronts_by_machine(
    candidates,
    ({ x }) => x,
    ({ y }) => y,
  );
  const starts = (i) => i === 0 || front[i - 1].machine !== front[i].machine;
  const named = front.filter(
    ({ y }, i) => starts(i) || y * TELLING <= front[i - 1].y || i === front.length - 1,
  );
  const height = HEIGHT + 60;
  const moved = name_places(
    named.map(({ y }) => y),
    axes.y_domain,
    height,
  );
  const labels = named.map((row, i) => ({
    ...row,
    name: `${row.who}, ${short_name(row.case)}`,
    label_place: moved[i],
  }));
  const told = labels.map(
    ({ name, x, y }) => `${name} (${format_seconds(x)} ${axes.unit}, ${Number(y.toPrecision(2))})`,
  );
  const encoding = { x: axes.x(ROOM), y: axes.y };
  const failed = rows.length - candidates.length;
  return {
    title: `Work and precision: ${precision.quantity} over CPU time`,
    wide: true,
    caption:
      `Lower left is better. Stepped: the Pareto front of ${rows.length} runs, named where the next is ` +
      `better by a factor of ${TELLING}. Thin lines join the values of ${at}. ` +
      marks_words(channels.contacts, failed),
    description:
      `${precision.quantity} over CPU time of ${rows.length} runs, ${failed} of which failed. ` +
      `Pareto front: ${told.join("; ")}.`,
    spec: {
      height,
      layer: [
        ...layers(rows, encoding, channels, axes.unit, true),
        {
          data: { values: front },
          mark: { type: "line", color: "$ink", strokeWidth: 1.6, interpolate: "step-after" },
          encoding: { ...encoding, detail: BY_MACHINE },
        },
        {
          data: { values: front },
          mark: { type: "point", color: "$ink", size: 130, strokeWidth: 1.6, opacity: 1 },
          encoding,
        },
        {
          data: { values: labels },
          mark: { type: "text", align: "right", baseline: "middle", dx: -11, fontSize: 11 },
          encoding: {
            x: encoding.x,
            y: pixel("label_place"),
            text: { field: "name" },
            color: channels.color,
          },
        },
      ],
    },
  };
}

// One value of the other parameters: every line named at its precise end.
function panel(line, rows, channels, axes) {
  const encoding = { x: axes.x(1), y: axes.y };
  const ends = [...group_by(rows, ({ who }) => who).values()].map((group) => {
    const last = group.reduce((a, b) => (b.x > a.x ? b : a));
    return { ...last, name: last.failure ? `✕ ${last.who}` : last.who };
  });
  const height = height_for(ends.length, HEIGHT - 40);
  const failed = rows.filter(({ failure }) => failure).length;
  return {
    title: `Work and precision at ${line}`,
    caption: marks_words(channels.contacts, failed),
    description: `Work and precision of ${rows.length} runs at ${line}.`,
    spec: {
      height,
      layer: [
        ...layers(rows, encoding, channels, axes.unit, false),
        ...end_labels(ends, { domain: axes.y_domain, height, color: channels.color }),
      ],
    },
  };
}

/** `entries`: [{record, variant}] of a family for which is_rule_work() holds. */
export function rule_work_plots(all) {
  // What was not there to be run, such as a build, has no place.
  const entries = all.filter(({ record }) => record.verdict !== "not-applicable");
  const quantities = compared_quantities(entries.map(({ record }) => record));
  const work = quantities.find(({ quantity }) => quantity === WORK);
  const precision = quantities.find(({ quantity }) => quantity !== WORK);
  if (!precision || !work) return [];
  const points = points_of(entries, precision.quantity);
  const channels = rule_channels(entries.map(({ variant }) => variant));
  const axes = axes_of(points, precision, work);
  const rows = rows_of(points, channels, axes);
  const lines = group_by(points, ({ line }) => line);
  const at = points[0].at.split("=")[0];
  return [
    overall(rows, channels, axes, precision, at),
    ...(lines.size > 1
      ? [...lines.keys()].map((line) =>
          panel(
            line,
            rows.filter((_, i) => points[i].line === line),
            channels,
            axes,
          ),
        )
      : []),
  ];
}
