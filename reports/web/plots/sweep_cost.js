// SPDX-License-Identifier: GPL-3.0-or-later
// What the points of a sweep cost: CPU time over two axes or more, a map a configuration and machine.
import { machines_of } from "../model/machine.js";
import { format_seconds, to_number } from "../model/number.js";
import { colour_scale } from "./colour_scale.js";
import { heat_map } from "./heat_map.js";

function point_of(record) {
  const seconds = to_number(record.cost.cpu_seconds);
  if (record.verdict === "error") return { record, value: null, text: "–", missing: "broke off" };
  if (!(seconds > 0)) return { record, value: null, text: "–", missing: "not measured" };
  return { record, value: seconds, text: `${format_seconds(seconds)} s` };
}

/** The maps of `series`, [{name, records}], over a layout; none where nothing was timed. */
export function cost_maps(series, layout) {
  const machines = machines_of(series.flatMap(({ records }) => records));
  return machines.flatMap(({ letter, name: machine, records: of_machine }) => {
    const there = new Set(of_machine);
    const own = series
      .map(({ name, records }) => ({
        name,
        points: records.filter((one) => there.has(one)).map(point_of),
      }))
      .filter(({ points }) => points.some(({ value }) => value !== null));
    const values = own
      .flatMap(({ points }) => points.map(({ value }) => value))
      .filter((value) => value !== null);
    if (values.length === 0) return [];
    // Its own for each machine: nothing is to be read from one to the other.
    const scale = colour_scale(values, "CPU time", "s");
    const where = machines.length > 1 ? `, machine ${letter}` : "";
    return own.map(({ name, points }) =>
      heat_map({
        kind: "sweep-cost",
        title: `${series.length > 1 ? `${name}: ` : ""}CPU time${where}`,
        points,
        layout,
        scale,
        notes: [
          machines.length > 1
            ? `Machine ${letter} of ${machines.length}, whose timings don't compare: ${machine}.`
            : `On ${machine}.`,
        ],
        value_name: "CPU time",
      }),
    );
  });
}
