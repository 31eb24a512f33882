// SPDX-License-Identifier: GPL-3.0-or-later
// What precision costs: relative error over CPU time. Small marks are records, large ones a variant's
// sum over the cases that all variants ran; the Pareto front joins the variants that no other beats.
import { group_by } from "../model/family.js";
import { format_seconds, to_number } from "../model/number.js";
import { log_domain, quantity_axis, rounded } from "./axes.js";
import { pareto_front } from "./fit.js";
import { numbered, tip, tip_number } from "./names.js";
import { SERIES_COLOURS, SERIES_SHAPES } from "./palette.js";
import { cut_words, MOST_VARIANTS, variant_channel } from "./series_plot.js";

const MOST_POINTS = 1500;
const TELLING = 2;
const SUM_SIZES = [330, 190, 110, 80, 60, 50, 40]; // px²; later ones lie on earlier ones

// The relative error of a record's least precise check with a scale that decides, or that is shown where none does
// (the old method); null when there is none.
function error_of(record) {
  const wanted = record.verdict === "for-information" ? ["for-information"] : ["pass", "fail", "expected-shortfall", "refuted"];
  const digits = record.checks
    .filter(({ verdict, digits: own }) => own !== undefined && wanted.includes(verdict))
    .map((check) => to_number(check.digits))
    .filter(Number.isFinite);
  return digits.length > 0 ? 10 ** -Math.min(...digits) : null;
}

// Largest ÷ smallest.
function spread(points, field) {
  const values = points.map((point) => point[field]);
  return (
    values.reduce((a, b) => Math.max(a, b), 0) / values.reduce((a, b) => Math.min(a, b), Infinity)
  );
}

/**
 * `entries`: [{variant, record}] of one family. Null when nothing was both timed and measured, or when
 * all lies on one spot.
 */
export function work_precision_plot(entries) {
  const points = entries
    .map(({ variant, record }) => ({
      variant,
      case: record.case,
      seconds: to_number(record.cost.cpu_seconds),
      error: error_of(record),
    }))
    .filter(({ seconds, error }) => seconds > 0 && error !== null);
  if (!(spread(points, "seconds") >= TELLING || spread(points, "error") >= TELLING)) return null;
  const variants = [...group_by(points, ({ variant }) => variant).entries()];
  const cases = variants.map(([, group]) => new Set(group.map((point) => point.case)));
  const shared = [...cases[0]].filter((name) => cases.every((set) => set.has(name)));
  const is_shared = new Set(shared);
  const sums =
    variants.length < 2 || shared.length === 0
      ? []
      : variants.map(([variant, group]) => {
          const counted = group.filter((point) => is_shared.has(point.case));
          return {
            variant,
            case: `${shared.length} shared case${shared.length > 1 ? "s" : ""}`,
            seconds: counted.reduce((sum, { seconds }) => sum + seconds, 0),
            error: counted.reduce((most, { error }) => Math.max(most, error), 0),
          };
        });
  const candidates = sums.length > 0 ? sums : points;
  const front = pareto_front(
    candidates,
    ({ seconds }) => seconds,
    ({ error }) => error,
  );
  const names = numbered(variants.map(([variant]) => variant).slice(0, MOST_VARIANTS));
  const round = (list) =>
    list.map((point) => ({
      ...point,
      variant_key: names.key_of(point.variant) ?? MOST_VARIANTS - 1,
      seconds: rounded(point.seconds),
      error: rounded(point.error),
    }));
  const all = [...points, ...sums];
  const encoding = {
    x: quantity_axis("seconds", "CPU time", "s", {
      log: true,
      domain: log_domain(all.map(({ seconds }) => seconds)),
    }),
    y: quantity_axis("error", "relative error of the least precise check", "1", {
      log: true,
      domain: log_domain(all.map(({ error }) => error)),
    }),
    color: variant_channel(names, SERIES_COLOURS),
    shape: variant_channel(names, SERIES_SHAPES),
    tooltip: [
      tip("case", "case"),
      tip("variant", "variant"),
      tip_number("seconds", "CPU s"),
      tip_number("error", "relative error"),
    ],
  };
  const on_front = front
    .map(
      ({ variant, case: name, seconds }) =>
        `${sums.length > 0 ? variant : name} (${format_seconds(seconds)} s)`,
    )
    .slice(0, 4)
    .join(", ");
  return {
    title: "Work and precision",
    caption:
      `Lower left is better. Dashed: Pareto front, ${on_front}${front.length > 4 ? ", …" : ""}.` +
      (sums.length > 0
        ? ` Large marks: each variant over the ${shared.length} case${shared.length > 1 ? "s" : ""} that all variants ran (sum of times, worst error).`
        : "") +
      (cut_words(variants.length) && ` Named: ${cut_words(variants.length).toLowerCase()}`),
    description: `Relative error over CPU time of ${points.length} records.`,
    spec: {
      height: 260,
      layer: [
        {
          data: { values: round(front) },
          mark: {
            type: "line",
            color: "$muted",
            strokeDash: [5, 4],
            strokeWidth: 1.5,
            interpolate: "step-after",
          },
          encoding: { x: encoding.x, y: encoding.y },
        },
        {
          data: { values: round(points.slice(0, MOST_POINTS)) },
          mark: { type: "point", size: 38, strokeWidth: 1.6, opacity: 0.75, cursor: "pointer" },
          encoding,
        },
        ...(sums.length > 0
          ? [
              {
                data: { values: round(sums) },
                mark: { type: "point", filled: true, opacity: 1 },
                encoding: {
                  ...encoding,
                  size: {
                    field: "variant_key",
                    type: "ordinal",
                    scale: { domain: names.keys, range: SUM_SIZES.slice(0, names.keys.length) },
                    legend: null,
                  },
                },
              },
            ]
          : []),
      ],
    },
  };
}
