// SPDX-License-Identifier: GPL-3.0-or-later
// History: a number of a family over the runs, in the order of their dates.
import { group_by } from "../model/family.js";
import { to_number } from "../model/number.js";
import { variant_key } from "../model/variant.js";
import { fewest_digits } from "../model/verdict.js";
import { quantity_axis, rounded } from "./axes.js";
import { numbered, tip, tip_number } from "./names.js";

// Records of each run that every run has, so that sums compare like with like.
function shared_records(by_run) {
  const keys = by_run.map(
    (records) => new Set(records.map((record) => `${record.case} ${variant_key(record)}`)),
  );
  return by_run.map((records) =>
    records.filter((record) =>
      keys.every((set) => set.has(`${record.case} ${variant_key(record)}`)),
    ),
  );
}

/** Plots of a family's cost and digits; none below two runs. `runs`: [{name, date}], record.run its index. */
export function trend_plots(records, runs) {
  const groups = group_by(records, ({ run }) => run);
  const order = [...groups.keys()].sort((a, b) => (runs[a].date < runs[b].date ? -1 : 1));
  if (order.length < 2) return [];
  const shared = shared_records(order.map((run) => groups.get(run).map(({ record }) => record)));
  if (shared[0].length === 0) return [];
  const of_run = (measure) =>
    order
      .map((run, i) => ({ run: runs[run].short, run_key: i, value: rounded(measure(shared[i])) }))
      .filter(({ value }) => value !== null);
  const names = numbered(order.map((run) => runs[run].short));
  const plot = (title, name, unit, values) => ({
    kind: "trend",
    title,
    caption: `Over ${shared[0].length} record${shared[0].length > 1 ? "s" : ""} that every run has.`,
    description: `${title}: ${values.map(({ run, value }) => `${run} ${value}`).join(", ")}`,
    spec: {
      height: 160,
      data: { values },
      mark: { type: "line", point: { filled: true, size: 60 }, color: "$s0", strokeWidth: 1.5 },
      encoding: {
        x: {
          field: "run_key",
          type: "ordinal",
          scale: { domain: names.keys },
          axis: { title: "run", labelAngle: -25, labelExpr: names.labels },
        },
        y: quantity_axis("value", name, unit, { zero: true }),
        tooltip: [tip("run", "run"), tip_number("value", name)],
      },
    },
  });
  const seconds = of_run((list) =>
    list.reduce((sum, record) => sum + to_number(record.cost.cpu_seconds), 0),
  );
  const digits = of_run((list) =>
    list.reduce((least, record) => Math.min(least, fewest_digits(record) ?? Infinity), Infinity),
  );
  return [
    plot("CPU time, run by run", "CPU time", "s", seconds),
    ...(digits.length > 0
      ? [plot("Fewest digits, run by run", "digits of the least precise check", "1", digits)]
      : []),
  ];
}
