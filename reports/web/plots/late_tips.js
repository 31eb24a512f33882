// SPDX-License-Identifier: GPL-3.0-or-later
// What a mark tells is worked out when it is pointed at: for each of ten thousand marks, of which hardly any is, it
// would take a fifth of the time that their picture does.
import { with_parts } from "./panel_size.js";

const told = (value, type, format) =>
  type === "quantitative" ? format(value) : Array.isArray(value) ? value.join("\n") : String(value);

/**
 * {spec, tip_of(place, datum)}: the specification with a place in a list for each list of tooltips, and what that one
 * tells of a datum, {title: text}. `format` makes numbers of quantities text.
 */
export function late_tips(spec, format) {
  const lists = [];
  const late = with_parts(spec, (part) => {
    const { encoding } = part;
    if (!Array.isArray(encoding?.tooltip)) return part;
    const tooltip = { value: String(lists.push(encoding.tooltip) - 1) };
    return { ...part, encoding: { ...encoding, tooltip } };
  });
  const tip_of = (place, datum) =>
    Object.fromEntries(
      lists[place].map(({ field, title, type }) => [title, told(datum[field], type, format)]),
    );
  return { spec: late, tip_of };
}
