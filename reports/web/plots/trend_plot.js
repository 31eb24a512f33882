// SPDX-License-Identifier: GPL-3.0-or-later
// History: a number of a family over the runs, in the order of their dates.
import { group_by } from "../model/family.js";
import { letters_of, timings_sentence } from "../model/machine.js";
import { to_number } from "../model/number.js";
import { variant_key } from "../model/variant.js";
import { fewest_digits } from "../model/verdict.js";
import { quantity_axis, rounded } from "./axes.js";
import { numbered, tip, tip_number } from "./names.js";
import { SERIES_COLOURS, SERIES_SHAPES } from "./palette.js";

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

// The line is broken between runs on different machines.
function broken_by_machine(plot, kinds, records) {
  if (kinds.length < 2) return plot;
  const letters = numbered(kinds);
  const channel = (range) => ({
    field: "machine_key",
    type: "ordinal",
    scale: { domain: letters.keys, range: letters.keys.map((i) => range[i % range.length]) },
    legend: { labelExpr: letters.labels },
  });
  const { encoding, ...spec } = plot.spec;
  return {
    ...plot,
    caption: `${plot.caption} ${timings_sentence(records)}`,
    spec: {
      ...spec,
      encoding: {
        ...encoding,
        color: channel(SERIES_COLOURS),
        shape: channel(SERIES_SHAPES),
        tooltip: [...encoding.tooltip, tip("machine", "machine")],
      },
    },
  };
}

/** Plots of a family's cost and digits; none below two runs. `runs`: [{name, date}], record.run its index. */
export function trend_plots(records, runs) {
  const groups = group_by(records, ({ run }) => run);
  const order = [...groups.keys()].sort((a, b) => (runs[a].date < runs[b].date ? -1 : 1));
  if (order.length < 2) return [];
  const shared = shared_records(order.map((run) => groups.get(run).map(({ record }) => record)));
  if (shared[0].length === 0) return [];
  const names = numbered(order.map((run) => runs[run].short));
  const machines = shared.map(letters_of);
  const kinds = [...new Set(machines)];
  const of_run = (measure) =>
    order
      .map((run, i) => ({
        run: runs[run].short,
        run_key: i,
        value: rounded(measure(shared[i])),
        machine: machines[i],
        machine_key: kinds.indexOf(machines[i]),
      }))
      .filter(({ value }) => value !== null);
  const words = `Over ${shared[0].length} record${shared[0].length > 1 ? "s" : ""} that every run has.`;
  const plot = (title, name, unit, values) => ({
    kind: "trend",
    title,
    caption: words,
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
  const seconds = plot(
    "CPU time, run by run",
    "CPU time",
    "s",
    of_run((list) => list.reduce((sum, record) => sum + to_number(record.cost.cpu_seconds), 0)),
  );
  const digits = of_run((list) =>
    list.reduce((least, record) => Math.min(least, fewest_digits(record) ?? Infinity), Infinity),
  );
  return [
    broken_by_machine(seconds, kinds, shared.flat()),
    ...(digits.length > 0
      ? [plot("Fewest digits, run by run", "digits of the least precise check", "1", digits)]
      : []),
  ];
}
