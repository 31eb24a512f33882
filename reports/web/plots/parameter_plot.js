// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity over a parameter: convergence with the observed order, scaling with the fitted exponent,
// or a plain dependence. A power law is fitted only over what has a size, and only where the points follow one.
import { name_with_unit, to_number } from "../model/number.js";
import { quantity_axis, rounded, wants_log } from "./axes.js";
import { clear_power_law } from "./fit.js";
import { tip, tip_number } from "./names.js";
import { cut_words, told_apart, variant_channels } from "./variant_channels.js";

const STEP = /step|size|spacing|width|Δ|^h$|^dt$/i;
const ERROR = /error|deviation|difference|residual/i;
const COUNT = /contact|bod(y|ies)|vert(ex|ices)|element|cell|thread|size|count|number/i;
const SIZE = /^(resolution|refinement)\b/i;
const COST_UNITS = ["s", "ms", "µs", "ns", "instructions", "byte", "B"];

/** "convergence", "scaling" or "dependence". */
export function kind_of(series) {
  if (COUNT.test(series.x_name) && COST_UNITS.includes(series.unit)) return "scaling";
  if (STEP.test(series.x_name) && ERROR.test(series.name)) return "convergence";
  return "dependence";
}

/** Whether x is a size and not the number of a pose, a seed, an ingredient or a step: those follow no law. */
export const is_size = ({ x_name, x_unit }) =>
  x_unit !== "1" || COUNT.test(x_name) || SIZE.test(x_name);

const WORDS = {
  convergence: { title: "Convergence: ", exponent: "observed order" },
  scaling: { title: "Scaling: ", exponent: "exponent" },
  dependence: { title: "", exponent: "exponent" },
};

// Of what is only numbered: whole numbers where it has them.
function number_axis(x_name, values) {
  const axis = quantity_axis("x", x_name, "1");
  const whole = values.every(({ x }) => Number.isInteger(x));
  return whole ? { ...axis, axis: { ...axis.axis, tickMinStep: 1, format: "d" } } : axis;
}

// Beside each fitted line its exponent; once when all agree.
function exponent_labels(fits, lines, word) {
  const texts = fits.map(({ fit }) => `${word} ${fit.exponent.toFixed(2)}`);
  const agree = new Set(texts).size === 1;
  return fits
    .map(({ label }, i) => {
      const [a, b] = lines.filter(({ variant }) => variant === label);
      return {
        variant_key: a.variant_key,
        x: Math.sqrt(a.x * b.x),
        y: Math.sqrt(a.y * b.y),
        text: agree || !label ? texts[i] : `${label}: ${texts[i]}`,
      };
    })
    .slice(0, agree ? 1 : fits.length);
}

export function parameter_plot(curves) {
  const shown = told_apart(curves);
  const { name, unit, x_name, x_unit } = shown[0].series;
  const kind = kind_of(shown[0].series);
  const raw = shown.flatMap(({ label, series }) =>
    series.x.map((x, i) => ({ variant: label, x: to_number(x), y: to_number(series.y[i]) })),
  );
  const signed = raw.some(({ y }) => y < 0);
  const magnitude = signed && (kind === "convergence" || raw.every(({ y }) => y < 0));
  const channels = variant_channels(shown);
  const variants = channels.names;
  const values = raw.map(({ variant, x, y }) => ({
    variant,
    variant_key: variants.key_of(variant),
    x: rounded(x),
    y: rounded(magnitude ? Math.abs(y) : y),
  }));
  const measured = values.filter(({ y }) => y !== null);
  const positive = measured.length > 0 && measured.every(({ y }) => y > 0);
  const with_size = is_size(shown[0].series);
  const log_x = with_size && positive && values.every(({ x }) => x > 0);
  const log_y = log_x || (positive && wants_log(measured.map(({ y }) => y)));
  const y_name = magnitude ? `|${name}|` : name;

  const fits = log_x
    ? shown
        .map(({ label }) => ({
          label,
          fit: clear_power_law(measured.filter(({ variant }) => variant === label)),
        }))
        .filter(({ fit }) => fit)
    : [];
  const lines = fits.flatMap(({ label, fit }) => {
    const xs = measured.filter(({ variant }) => variant === label).map(({ x }) => x);
    return [Math.min(...xs), Math.max(...xs)].map((x) => ({
      variant: label,
      variant_key: variants.key_of(label),
      x,
      y: rounded(fit.factor * x ** fit.exponent),
    }));
  });
  const marks = exponent_labels(fits, lines, WORDS[kind].exponent);
  const exponents = fits.map(
    ({ label, fit }) =>
      `${label ? `${label}: ` : ""}${WORDS[kind].exponent} ${fit.exponent.toFixed(3)}`,
  );
  const encoding = {
    x: with_size ? quantity_axis("x", x_name, x_unit, { log: log_x }) : number_axis(x_name, values),
    y: quantity_axis("y", y_name, unit, { log: log_y }),
    color: channels.channel(channels.colours),
  };
  return {
    kind,
    title: `${WORDS[kind].title}${name} over ${x_name}`,
    caption: [
      cut_words(curves.length),
      exponents.length > 0 && `Dashed: fitted power law; ${exponents.join("; ")}.`,
      measured.length < values.length &&
        `${values.length - measured.length} of ${values.length} values are no finite number and left out.`,
    ]
      .filter(Boolean)
      .join(" "),
    description: `${y_name} over ${name_with_unit(x_name, x_unit)}. ${exponents.join("; ")}`,
    spec: {
      height: 220,
      layer: [
        ...(lines.length > 0
          ? [
              {
                data: { values: lines },
                mark: { type: "line", strokeDash: [5, 4], strokeWidth: 1.5 },
                encoding,
              },
              {
                data: { values: marks },
                mark: {
                  type: "text",
                  align: fits[0].fit.exponent > 0 ? "right" : "left",
                  dx: fits[0].fit.exponent > 0 ? -8 : 8,
                  dy: -12,
                  color: "$ink",
                },
                encoding: { x: encoding.x, y: encoding.y, text: { field: "text" } },
              },
            ]
          : []),
        {
          data: { values },
          mark: { type: "point", filled: true, size: 70, opacity: 1 },
          encoding: {
            ...encoding,
            shape: channels.channel(channels.shapes),
            tooltip: [tip("variant", "variant"), tip_number("x", x_name), tip_number("y", y_name)],
          },
        },
      ],
    },
  };
}
