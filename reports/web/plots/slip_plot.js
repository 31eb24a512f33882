// SPDX-License-Identifier: GPL-3.0-or-later
// Does it hold or creep? Slip over time of the configurations in the one scene that tells them apart best.
import { configuration_of, ordered_configurations } from "../model/configuration.js";
import { group_by } from "../model/family.js";
import { to_number } from "../model/number.js";
import { series_plot } from "./series_plot.js";

const is_slip = ({ name, unit, x_name }) =>
  x_name === "time" && unit === "m/s" && /\b(slip|creep)\b/i.test(name);

const TINY = 1e-30; // m/s: below it all is rest

// How many configurations there are, and over how many decades their ends spread.
function spread_of(curves) {
  const ends = curves.map(({ series }) => Math.max(TINY, Math.abs(to_number(series.y.at(-1)))));
  const finite = ends.filter(Number.isFinite);
  return finite.length < 2 ? 0 : Math.log10(Math.max(...finite) / Math.min(...finite));
}

/** Null where no scene has slip over time of two configurations whose ends differ. */
export function slip_plot(records, name_of = configuration_of) {
  const curves = records.flatMap((record) =>
    record.series
      .filter((series) => is_slip(series) && series.y.length > 1)
      .map((series) => ({
        record,
        series,
        configuration: name_of(record),
        label: name_of(record),
      })),
  );
  const groups = group_by(curves, ({ record, series }) => `${record.case}\n${series.name}`);
  let best = null;
  for (const group of groups.values()) {
    const own = [...group_by(group, ({ label }) => label).values()].map(([first]) => first);
    const spread = spread_of(own);
    if (own.length < 2 || spread < 1) continue;
    const longer =
      best && own.length === best.own.length ? spread > best.spread : own.length > best?.own.length;
    if (!best || longer) best = { own, spread };
  }
  if (!best) return null;
  const order = ordered_configurations(best.own.map(({ label }) => label));
  const own = order.map((name) => best.own.find(({ label }) => label === name));
  const [{ record, series }] = own;
  const plot = series_plot(own, { height: 150 });
  return {
    ...plot,
    case: record.case,
    title: "Does it hold or creep?",
    caption: `${series.name} in ${record.case}. ${plot.caption}`,
  };
}
