// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity over the runs of a history: whole numbers, and a point at each.
import { series_plot } from "./series_plot.js";

/** `curves`: as series_plot() takes them. */
export function run_plot(curves) {
  const plot = series_plot(curves);
  const [{ mark, encoding, ...line }, ...rules] = plot.spec.layer;
  const x = { ...encoding.x, axis: { ...encoding.x.axis, tickMinStep: 1, format: "d" } };
  return {
    kind: "trend",
    ...plot,
    spec: {
      ...plot.spec,
      layer: [
        {
          ...line,
          mark: { ...mark, point: { filled: true, size: 40 }, clip: false },
          encoding: { ...encoding, x },
        },
        ...rules,
      ],
    },
  };
}
