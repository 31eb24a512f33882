// SPDX-License-Identifier: GPL-3.0-or-later
// How a comparison's variants went, step by step: both axes logarithmic, one picture for each kind of
// contacts with the same axes, every curve named at its end.
import { failure_of, figure_text } from "../model/figure.js";
import { to_number } from "../model/number.js";
import { log_domain, quantity_axis } from "./axes.js";
import { end_labels, height_for } from "./end_labels.js";
import { tip, tip_number } from "./names.js";
import { on_contacts, rule_channels } from "./rule_channels.js";

const HEIGHT = 300; // px
const short = (value) => (Number.isFinite(value) ? Number(value.toPrecision(4)) : null);

/** Whether series are histories: their x count from 1 or later. */
export const is_history = ({ x, x_unit }) =>
  x_unit === "1" && x.every((value) => Number.isInteger(value) && value > 0);

function panel(curves, contacts, { channels, x, y_domain, quantity }) {
  const height = height_for(curves.length, HEIGHT);
  const at = (value) => (value > 0 ? value : y_domain[0]);
  const values = curves.flatMap(({ variant, series }, curve_key) =>
    series.x.map((step, i) => {
      const y = short(to_number(series.y[i]));
      return {
        variant: variant.name,
        curve_key,
        ...channels.keys_of(variant),
        x: short(to_number(step)),
        y: y === null ? null : at(y),
      };
    }),
  );
  const ends = curves.map(({ variant, series, record }) => {
    const last = to_number(series.y.at(-1));
    const failure = failure_of(record);
    return {
      name: failure ? `✕ ${variant.name}` : variant.name,
      ...channels.keys_of(variant),
      case: record.case,
      x: short(to_number(series.x.at(-1))),
      y: Number.isFinite(last) ? at(last) : y_domain[1],
      last: figure_text(last),
      failure: failure || "held to the end",
    };
  });
  const failed = ends.filter((_, i) => failure_of(curves[i].record));
  const { name, unit, x_name } = quantity;
  const encoding = {
    x,
    y: quantity_axis("y", name, unit, { log: true, domain: y_domain }),
  };
  const tooltip = [tip("name", "rule"), tip("last", "at the end"), tip("failure", "held")];
  return {
    kind: "history",
    title: `${name}${on_contacts(contacts)}, step by step`,
    caption: [
      failed.length === curves.length
        ? `All ${curves.length} fail (✕): none holds to the end.`
        : failed.length > 0 && `✕ marks the ${failed.length} of ${curves.length} that fail.`,
      curves.some(({ series }) => series.y.includes(0)) &&
        "Zeros stand at the lower edge of the logarithmic axis.",
    ]
      .filter(Boolean)
      .join(" "),
    description: `${name} over ${x_name}${on_contacts(contacts)}: ${curves.length} curves.`,
    spec: {
      height,
      layer: [
        {
          data: { values },
          mark: { type: "line", strokeWidth: 1.6, strokeCap: "butt", clip: true },
          encoding: {
            ...encoding,
            color: channels.color,
            strokeDash: channels.dash,
            detail: { field: "curve_key" },
            tooltip: [tip("variant", "rule"), tip_number("x", x_name), tip_number("y", name)],
          },
        },
        {
          data: { values: failed },
          mark: { type: "point", shape: "cross", angle: 45, filled: true, size: 60, opacity: 1 },
          encoding: { ...encoding, color: channels.color, tooltip },
        },
        ...end_labels(ends, { domain: y_domain, height, color: channels.color, tooltip }),
      ],
    },
  };
}

/** `curves`: [{variant, series, record}], variants as rules_on_contacts() gives them. None is left out. */
export function history_plots(curves) {
  const channels = rule_channels(curves.map(({ variant }) => variant));
  const ys = curves.flatMap(({ series }) => series.y.map(to_number));
  const last = curves.reduce((most, { series }) => Math.max(most, to_number(series.x.at(-1))), 1);
  const [{ series: quantity }] = curves;
  const shared = {
    channels,
    quantity,
    y_domain: log_domain(ys),
    x: quantity_axis("x", quantity.x_name, quantity.x_unit, { log: true, domain: [1, last] }),
  };
  return channels.contacts.map((contacts) =>
    panel(
      curves.filter(({ variant }) => variant.contacts === contacts),
      contacts,
      shared,
    ),
  );
}
