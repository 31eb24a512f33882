// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison's figure over a parameter, negative and positive: the figure's axis is logarithmic, and
// where the parameter made a variant fail a cross stands at the upper edge.
import { failed_values } from "../model/figure.js";
import { to_number } from "../model/number.js";
import { log_domain, quantity_axis, rounded, signed_axis } from "./axes.js";
import { end_labels, height_for } from "./end_labels.js";
import { tip, tip_number } from "./names.js";
import { on_contacts, rule_channels } from "./rule_channels.js";

const HEIGHT = 260; // px

/** `curves`: [{variant, series, record}]. */
export function sweep_plots(curves) {
  const channels = rule_channels(curves.map(({ variant }) => variant));
  const { name, unit, x_name, x_unit } = curves[0].series;
  const y_domain = log_domain(curves.flatMap(({ series }) => series.y.map(to_number)));
  const all_x = curves.flatMap(({ series, record }) => [
    ...series.x.map(to_number),
    ...failed_values(record, x_name),
  ]);
  const x_domain = [
    all_x.reduce((a, b) => Math.min(a, b), Infinity),
    all_x.reduce((a, b) => Math.max(a, b), -Infinity),
  ];
  return channels.contacts.map((contacts) => {
    const own = curves.filter(({ variant }) => variant.contacts === contacts);
    const height = height_for(own.length, HEIGHT);
    const keys = (variant) => ({ variant: variant.name, ...channels.keys_of(variant) });
    const measured = own.map(({ variant, series }) =>
      series.x.map((x, i) => ({
        ...keys(variant),
        x: rounded(to_number(x)),
        y: rounded(Math.max(y_domain[0], to_number(series.y[i]))),
      })),
    );
    const failed = own.flatMap(({ variant, record }) =>
      failed_values(record, x_name).map((x) => ({
        ...keys(variant),
        x,
        y: y_domain[1],
        failure: `failed at ${x_name} = ${x}`,
      })),
    );
    // A line does not run through a value that failed.
    const gaps = failed.map((point) => ({ ...point, y: null, failure: "" }));
    const best = measured.map((points) => points.reduce((a, b) => (b.y < a.y ? b : a)));
    const encoding = {
      x: signed_axis("x", x_name, x_unit, all_x, { domain: x_domain }),
      y: quantity_axis("y", name, unit, { log: true, domain: y_domain }),
      color: channels.color,
    };
    const tooltip = [tip("variant", "rule"), tip_number("x", x_name), tip_number("y", name)];
    const told = best.map(({ variant, x, y }) => `${variant} ${Number(y.toPrecision(2))} at ${Number(x.toPrecision(2))}`);
    return {
      kind: "sweep",
      title: `${name} over ${x_name}${on_contacts(contacts)}`,
      caption:
        `Least: ${told.join("; ")} (ringed).` +
        (failed.length > 0 ? ` ✕ at the upper edge: ${failed.length} values fail.` : ""),
      description: `${name} over ${x_name} from ${x_domain[0]} to ${x_domain[1]}. ${told.join("; ")}`,
      spec: {
        height,
        layer: [
          {
            data: { values: [...measured.flat(), ...gaps] },
            mark: { type: "line", strokeWidth: 1.6, point: { filled: true, size: 26 } },
            encoding: { ...encoding, strokeDash: channels.dash, tooltip },
          },
          {
            data: { values: best },
            mark: { type: "point", size: 150, strokeWidth: 2, opacity: 1 },
            encoding: { ...encoding, tooltip },
          },
          {
            data: { values: failed },
            mark: { type: "point", shape: "cross", angle: 45, filled: true, size: 70, opacity: 1 },
            encoding: { ...encoding, tooltip: [tip("variant", "rule"), tip("failure", "here")] },
          },
          ...end_labels(
            measured.map((points) => ({ ...points.at(-1), name: points[0].variant })),
            { domain: y_domain, height, color: channels.color },
          ),
        ],
      },
    };
  });
}
